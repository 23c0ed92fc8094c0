#include <stiction/base/errors.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/mesh/node_order.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/simulation/checkpoint/checkpoint.h>
#include <stiction/simulation/checkpoint/checkpoint_files.h>
#include <stiction/simulation/checkpoint/problem_identity.h>
#include <stiction/simulation/checkpoint/word_file.h>
#include <stiction/simulation/parameters/parameters.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <filesystem>

namespace stiction
{
  using nlohmann::json;
  using word_file::Words;

  namespace
  {
    // Of a contact node: its place in the order of nodes, force, where its slip is
    // counted from, and the way that it has slipped.
    constexpr Eigen::Index words_of_contact_node = 8;

    // Of the nodes of this rank.
    Words displacement_words(const LA::Vector &u, const NodeOrder &order)
    {
      std::vector<double> numbers;
      for (const auto dof : order.first_dofs())
        for (unsigned int c = 0; c < 3; ++c)
          numbers.push_back(u(dof + c));
      return word_file::of_numbers(numbers);
    }

    // The state has all contact nodes on every rank. Collective.
    Words contact_words(const State &state, const NodeOrder &order)
    {
      const SlipHistory &history = state.history;
      const auto m               = static_cast<Eigen::Index>(history.nodes.size());
      const Words places         = order.places_of(history.nodes);
      Words words;
      for (Eigen::Index i = 0; i < m; ++i)
        {
          std::vector<double> numbers;
          for (const Eigen::VectorXd *const v : {&state.lambda, &history.origin})
            for (Eigen::Index c = 0; c < 3; ++c)
              numbers.push_back((*v)(i + c * m));
          numbers.push_back(history.path(i));
          words.push_back(places[i]);
          for (const std::uint64_t word : word_file::of_numbers(numbers))
            words.push_back(word);
        }
      return words;
    }

    void read_contact(const Words &words, const NodeOrder &order, State &state)
    {
      const auto m = static_cast<Eigen::Index>(words.size()) / words_of_contact_node;
      const std::vector<double> numbers = word_file::to_numbers(words);
      state.lambda.resize(3 * m);
      state.history.origin.resize(3 * m);
      state.history.path.resize(m);
      Words places;
      for (Eigen::Index i = 0; i < m; ++i)
        {
          const Eigen::Index k = words_of_contact_node * i;
          places.push_back(words[k]);
          for (Eigen::Index c = 0; c < 3; ++c)
            {
              state.lambda(i + c * m)         = numbers[k + 1 + c];
              state.history.origin(i + c * m) = numbers[k + 4 + c];
            }
          state.history.path(i) = numbers[k + 7];
        }
      state.history.nodes = order.nodes_at(places);
    }

    std::string numbered(const std::string &name, const std::size_t k)
    {
      return name + "." + std::to_string(k);
    }
  } // namespace

  void write_checkpoint(const std::string &directory, const Checkpoint &checkpoint,
                        const MeshHistory &mesh, const LinearElasticity &elasticity,
                        const Parameters &parameters)
  {
    const Body &body    = elasticity.body();
    const MPI_Comm comm = body.communicator();
    const bool is_first = dealii::Utilities::MPI::this_mpi_process(comm) == 0;
    const NodeOrder order(body);
    const std::string unfinished = checkpoint_files::begin(directory, comm);

    json header     = {{"steps", checkpoint.steps},
                       {"history", checkpoint.history},
                       {"slave_sides", checkpoint.slave_sides},
                       {"cells", body.triangulation().n_global_active_cells()},
                       {"nodes", body.n_nodes()}};
    const auto file = [&](const std::string &name, const Words &words) {
      const auto digest     = word_file::write(unfinished + "/" + name, words, comm);
      header["files"][name] = {digest.n_words, digest.checksum};
    };
    file("refinements", mesh.words());
    for (std::size_t k = 0; k < checkpoint.ends.size(); ++k)
      {
        const auto &[time, state] = checkpoint.ends[k];
        file(numbered("displacement", k), displacement_words(state.u, order));
        const Words contact = contact_words(state, order);
        file(numbered("contact", k), is_first ? contact : Words());
        header["ends"].push_back(
          {{"time", time},
           {"force_scale", state.scales.force},
           {"energy_scale", state.scales.energy},
           {"angles", state.history.angles},
           {"distances",
            std::vector<double>(state.distances.begin(), state.distances.end())}});
      }
    do_on_first_rank(comm, [&]() {
      header["problem"] = problem_identity(parameters);
      checkpoint_files::finish(directory, header);
    });
  }

  CheckpointReader::CheckpointReader(const std::string &directory,
                                     const Parameters &parameters, MPI_Comm communicator)
    : communicator_(communicator)
  {
    std::string text;
    do_on_first_rank(communicator, [&]() {
      directory_ = checkpoint_files::find(directory);
      header_    = checkpoint_files::header(directory_);
      require_same_problem(parameters, header_.at("problem"), directory_);
      text = header_.dump();
    });
    directory_ = dealii::Utilities::MPI::broadcast(communicator, directory_);
    header_    = json::parse(dealii::Utilities::MPI::broadcast(communicator, text));
  }

  std::string CheckpointReader::output_directory() const
  {
    return std::filesystem::path(directory_ + "/..").lexically_normal().string();
  }

  MeshHistory CheckpointReader::mesh() const
  {
    const std::uint64_t n = header_.at("files").at("refinements").at(0);
    Words words;
    throw_on_all_ranks(communicator_, [&]() {
      words = word_file::read(directory_ + "/refinements", 0, n);
    });
    return MeshHistory(words);
  }

  Checkpoint CheckpointReader::read(const LinearElasticity &elasticity) const
  {
    const Body &body = elasticity.body();
    if (header_.at("nodes") != body.n_nodes() ||
        header_.at("cells") != body.triangulation().n_global_active_cells())
      throw InputError(directory_ + ": is of a mesh of " + header_.at("cells").dump() +
                       " cells and " + header_.at("nodes").dump() +
                       " nodes, must be of this one of " +
                       std::to_string(body.triangulation().n_global_active_cells()) +
                       " and " + std::to_string(body.n_nodes()) + ".");
    Checkpoint checkpoint{
      header_.at("steps"), header_.at("history"), {}, header_.at("slave_sides")};
    for (unsigned int k = 0; k < header_.at("ends").size(); ++k)
      checkpoint.ends.push_back(read_end(k, elasticity));
    return checkpoint;
  }

  StepEnd CheckpointReader::read_end(const unsigned int k,
                                     const LinearElasticity &elasticity) const
  {
    const NodeOrder order(elasticity.body());
    const json &end = header_.at("ends").at(k);
    StepEnd read{end.at("time").get<double>(), {elasticity.zero_vector(), {}, {}, {}}};

    const std::string contact = numbered("contact", k);
    Words displacement_words, contact_words;
    throw_on_all_ranks(communicator_, [&]() {
      displacement_words =
        word_file::read(directory_ + "/" + numbered("displacement", k), 3 * order.first(),
                        3 * order.first_dofs().size());
      contact_words = word_file::read(directory_ + "/" + contact, 0,
                                      header_.at("files").at(contact).at(0));
    });
    const std::vector<double> u = word_file::to_numbers(displacement_words);
    for (std::size_t i = 0; i < u.size(); ++i)
      read.state.u(order.first_dofs()[i / 3] + i % 3) = u[i];
    read_contact(contact_words, order, read.state);
    const auto distances = end.at("distances").get<std::vector<double>>();
    read.state.distances = Eigen::Map<const Eigen::VectorXd>(
      distances.data(), static_cast<Eigen::Index>(distances.size()));
    read.state.history.angles = end.at("angles").get<std::vector<double>>();
    read.state.scales         = {end.at("force_scale"), end.at("energy_scale")};
    return read;
  }
} // namespace stiction
