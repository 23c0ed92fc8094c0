// Two combs in each other, the one drawn against the other as a bolt in its nut: all
// flanks of each are one boundary, so that behind what touches a tooth lie others of the
// same boundary, as near as a tooth is thick. The answer is the one of a pair for each
// tooth, also where a tooth is shorter, and the next one is seen past its end.

#include "tests.h"

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <vector>

using namespace stiction;

namespace
{
  // Cells of 0.5 × 1 × 1: a spine and a tooth at every other height each. Flanks are of
  // one boundary or of one each.
  class Combs
  {
  public:
    explicit Combs(const bool is_one)
    {
      for (int k = 0; k < 6; ++k)
        {
          const std::string tooth = is_one ? "" : std::to_string(k / 2);
          const bool is_of_bolt   = k % 2 == 0;
          for (int i = -2; i < 4; ++i)
            if (i < 0 || i > 1 || !(k == 3 && i == 0))
              {
                const bool is_bolt = i < 0 || (i < 2 && is_of_bolt);
                add_cell(is_bolt, i, k);
                if (i == -2)
                  add_face("left", is_bolt,
                           {{{i, 0, k}, {i, 0, k + 1}, {i, 1, k + 1}, {i, 1, k}}});
                if (i == 3)
                  add_face("right", is_bolt,
                           {{{i + 1, 0, k},
                             {i + 1, 1, k},
                             {i + 1, 1, k + 1},
                             {i + 1, 0, k + 1}}});
                if (i < 0 && k == 5)
                  add_face("pull", is_bolt,
                           {{{i, 0, 6}, {i + 1, 0, 6}, {i + 1, 1, 6}, {i, 1, 6}}});
                if (i == 0 || i == 1)
                  {
                    const int z = is_of_bolt ? k + 1 : k;
                    add_face((is_of_bolt ? "bolt" : "nut") + tooth, is_bolt,
                             {{{i, 0, z}, {i + 1, 0, z}, {i + 1, 1, z}, {i, 1, z}}});
                  }
              }
        }
    }

    void write(const std::string &file) const
    {
      if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
        {
          std::ofstream mesh(file);
          mesh << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n"
               << names_.size() << '\n';
          for (const auto &[name, number] : names_)
            mesh << "2 " << number << " \"" << name << "\"\n";
          mesh << "$EndPhysicalNames\n$Nodes\n" << nodes_.size() << '\n';
          for (const auto &[node, number] : nodes_)
            mesh << number << ' ' << 0.5 * node[1] << ' ' << node[2] << ' ' << node[3]
                 << '\n';
          mesh << "$EndNodes\n$Elements\n" << elements_.size() << '\n';
          for (std::size_t e = 0; e < elements_.size(); ++e)
            mesh << e + 1 << ' ' << elements_[e] << '\n';
          mesh << "$EndElements\n";
        }
      MPI_Barrier(MPI_COMM_WORLD);
    }

  private:
    using Place = std::array<int, 3>;

    std::string numbers(const bool is_bolt, const std::vector<Place> &places)
    {
      std::string list;
      for (const Place &p : places)
        list += ' ' + std::to_string(
                        nodes_.try_emplace({is_bolt, p[0], p[1], p[2]}, nodes_.size() + 1)
                          .first->second);
      return list;
    }

    void add_cell(const bool is_bolt, const int i, const int k)
    {
      elements_.push_back("5 2 9 9" + numbers(is_bolt, {{i, 0, k},
                                                        {i + 1, 0, k},
                                                        {i + 1, 1, k},
                                                        {i, 1, k},
                                                        {i, 0, k + 1},
                                                        {i + 1, 0, k + 1},
                                                        {i + 1, 1, k + 1},
                                                        {i, 1, k + 1}}));
    }

    void add_face(const std::string &name, const bool is_bolt,
                  const std::vector<Place> &places)
    {
      const std::string number =
        std::to_string(names_.try_emplace(name, names_.size() + 1).first->second);
      elements_.push_back("3 2 " + number + ' ' + number + numbers(is_bolt, places));
    }

    std::map<std::array<int, 4>, std::size_t> nodes_;
    std::map<std::string, std::size_t> names_;
    std::vector<std::string> elements_;
  };

  std::string pair(const std::string &tooth, const std::string &slave_side)
  {
    return "subsection Contact pair " + (tooth.empty() ? "all" : tooth) +
           "\n  set Boundary    = bolt" + tooth + "\n  set Obstacle    = boundary : nut" +
           tooth + "\n  set Slave side  = " + slave_side +
           "\n  set Law         = coulomb\n  set Coefficient = 0.3\nend\n";
  }

  const std::string problem = R"(
subsection Geometry
  set Mesh file         = combs.msh
  set Global refinement = 1
end
subsection Material
  set Young's modulus = 1e9
  set Poisson ratio   = 0.3
end
subsection Boundary conditions
  set Prescribed displacement = left : 0; 0; free | right : 0; 0; 0
  set Traction                = pull : 0; 0; 1e5
end
subsection Contact solver
  set Tolerance = 1e-10
end
)";

  nlohmann::json solved(const bool is_one, const std::string &side,
                        const std::string &degree)
  {
    Combs(is_one).write("combs.msh");
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::ofstream("combs.prm")
        << problem
        << (is_one ? pair("", side)
                   : pair("0", side) + pair("1", side) + pair("2", side));
    MPI_Barrier(MPI_COMM_WORLD);
    return Run("combs.prm", {"Geometry/Element degree=" + degree}).summary();
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const std::string degree : {"1", "2"})
    for (const std::string side : {"boundary", "obstacle"})
      {
        const nlohmann::json one  = solved(true, side, degree),
                             each = solved(false, side, degree);
        const double u = each["displacement"]["max"], energy = each["energy"]["strain"];
        out() << "degree " << degree << ", slave side " << side << ": certified "
              << yes(one["converged"] && each["converged"]) << ", closed "
              << one["contact"]["closed"] << " and " << each["contact"]["closed"]
              << ", drawn up by the same to 1e-8 "
              << yes(std::abs(one["displacement"]["max"].get<double>() - u) < 1e-8 * u)
              << ", strain energy to 1e-8 "
              << yes(std::abs(one["energy"]["strain"].get<double>() - energy) <
                     1e-8 * energy)
              << std::endl;
      }
}
