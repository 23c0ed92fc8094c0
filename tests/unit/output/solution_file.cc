// solution.pvtu: strain and stress belong to each other and to the
// formulation, principal stresses to the stress, the averaged stress is that
// of the cells around a node, within its material and by volume, and the
// reactions add up to those of the summary.

#include "tests.h"
#include "vtu_file.h"

#include <stiction/elasticity/model/materials.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

using namespace stiction;

namespace
{
  using Place = std::tuple<float, float, float, float>; // and the material

  // Everything in the file that is not as it should be, relative.
  struct Errors
  {
    double law = 0., volume_strain = 0., von_mises = 0., principal = 0., averaged = 0.,
           reaction    = 0.;
    unsigned int nodes = 0;
  };

  // @param n_points of a cell.
  Errors check(const Run &run, const std::size_t n_points, const bool mean_dilatation,
               const bool has_hanging_nodes)
  {
    // the nodes of all pieces, the first cell's first
    std::map<std::string, std::vector<float>> a;
    for (unsigned int r = 0; r < dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
         ++r)
      for (auto &array : read_vtu("results/solution." +
                                  dealii::Utilities::int_to_string(r, 4) + ".vtu"))
        a[array.first].insert(a[array.first].end(), array.second.begin(),
                              array.second.end());
    const std::size_t n = a["material_id"].size();
    const auto &stress = a["stress"], &strain = a["strain"];
    const auto &mean = a["stress_averaged"], &principal = a["principal_stresses"];
    const double largest =
      *std::max_element(a["von_Mises_stress"].begin(), a["von_Mises_stress"].end());
    const double largest_strain =
      std::abs(*std::max_element(strain.begin(), strain.end()));

    struct Node
    {
      std::array<double, 9> sum{};
      double volume = 0.;
    };
    std::map<Place, Node> nodes;
    std::map<std::tuple<float, float, float>, bool> seen;
    std::array<double, 3> reaction{};
    Errors e;
    const auto place = [&](const std::size_t i) {
      const auto &x = a["points"];
      return Place(x[3 * i], x[3 * i + 1], x[3 * i + 2], a["material_id"][i]);
    };
    for (std::size_t i = 0; i < n; ++i)
      {
        const auto &material = run.problem->elasticity().materials().of(
          static_cast<unsigned int>(a["material_id"][i]));
        dealii::SymmetricTensor<2, 3> epsilon;
        double trace = 0., first_trace = 0., sum = 0.;
        for (unsigned int c = 0; c < 3; ++c)
          {
            for (unsigned int d = c; d < 3; ++d)
              epsilon[c][d] = strain[9 * i + 3 * c + d];
            trace += strain[9 * i + 4 * c];
            first_trace += strain[9 * (i / n_points * n_points) + 4 * c];
            sum += principal[3 * i + c] - stress[9 * i + 4 * c];
          }
        const auto sigma = material.stress(epsilon);
        for (unsigned int k = 0; k < 9; ++k)
          e.law = std::max(e.law, std::abs(sigma[k / 3][k % 3] - stress[9 * i + k]) /
                                    (material.lame_lambda + 2. * material.shear_modulus) /
                                    largest_strain);
        if (mean_dilatation)
          e.volume_strain =
            std::max(e.volume_strain, std::abs(trace - first_trace) / largest_strain);

        const double s1 = principal[3 * i], s2 = principal[3 * i + 1],
                     s3 = principal[3 * i + 2];
        e.von_mises     = std::max(
              e.von_mises, std::abs(std::sqrt(((s1 - s2) * (s1 - s2) + (s2 - s3) * (s2 - s3) +
                                           (s3 - s1) * (s3 - s1)) /
                                              2.) -
                                    a["von_Mises_stress"][i]) /
                             largest);
        e.principal = std::max(e.principal, std::abs(sum) / largest);
        if (s1 < s2 || s2 < s3)
          e.principal = 1.;

        const auto x = place(i);
        if (seen
              .emplace(std::make_tuple(std::get<0>(x), std::get<1>(x), std::get<2>(x)),
                       true)
              .second)
          for (unsigned int c = 0; c < 3; ++c)
            reaction[c] += a["reaction"][3 * i + c];

        // bricks: from one corner to the other
        const std::size_t first = i / n_points * n_points;
        double low[3], high[3];
        for (unsigned int c = 0; c < 3; ++c)
          {
            low[c] = high[c] = a["points"][3 * first + c];
            for (std::size_t p = first; p < first + n_points; ++p)
              {
                low[c]  = std::min<double>(low[c], a["points"][3 * p + c]);
                high[c] = std::max<double>(high[c], a["points"][3 * p + c]);
              }
          }
        const double volume =
          (high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2]);
        Node &node = nodes[x];
        for (unsigned int k = 0; k < 9; ++k)
          node.sum[k] += volume * stress[9 * i + k];
        node.volume += volume;
      }
    e.nodes = seen.size();
    for (std::size_t i = 0; i < n; ++i)
      for (unsigned int k = 0; k < 9; ++k)
        if (!has_hanging_nodes)
          e.averaged = std::max(
            e.averaged, std::abs(nodes.at(place(i)).sum[k] / nodes.at(place(i)).volume -
                                 mean[9 * i + k]) /
                          largest);

    // one value a node and material: hanging nodes between their neighbours
    std::map<Place, std::size_t> first_of;
    for (std::size_t i = 0; i < n; ++i)
      for (unsigned int k = 0; k < 9; ++k)
        e.averaged = std::max<double>(
          e.averaged,
          std::abs(mean[9 * i + k] -
                   mean[9 * first_of.emplace(place(i), i).first->second + k]) /
            largest);
    const auto &in_summary = run.summary()["reactions"]["boundaries"];
    double force           = 0.;
    for (unsigned int c = 0; c < 3; ++c)
      {
        for (const auto &boundary : in_summary)
          reaction[c] -= boundary["force"][c].get<double>();
        for (const auto &point : run.summary()["reactions"]["points"])
          reaction[c] -= point["force"][c].get<double>();
        force = std::max(force, std::abs(reaction[c]));
      }
    e.reaction = force / run.problem->certificate().force_scale();
    return e;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  struct Case
  {
    std::string name, file;
    Settings settings;
    std::size_t n_points   = 8;
    bool mean_dilatation   = false;
    bool has_hanging_nodes = false;
  };
  for (const Case &c : std::vector<Case>{
         {"two materials", "two_materials.prm", {"Geometry/Global refinement=1"}},
         {"mean dilatation", "rubber.prm", {}, 8, true},
         {"hanging nodes",
          "contact_refinement.prm",
          {"Contact solver/Method=newton"},
          8,
          false,
          true},
         {"triquadratic", "quadratic.prm", {}, 27}})
    {
      const Run run(shipped(c.file), c.settings);
      MPI_Barrier(MPI_COMM_WORLD); // the files of the others
      if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
        continue;
      const Errors e = check(run, c.n_points, c.mean_dilatation, c.has_hanging_nodes);
      out() << c.name << ": all nodes "
            << yes(e.nodes == run.summary()["problem"]["nodes"])
            << ", stress of the strain " << yes(e.law < 1e-5) << ", volume strain "
            << yes(e.volume_strain < 1e-5) << ", principal stresses "
            << yes(e.principal < 1e-4) << ", von Mises stress " << yes(e.von_mises < 1e-4)
            << ", averaged " << yes(e.averaged < 1e-5) << ", reactions "
            << yes(e.reaction < 1e-5) << std::endl;
    }
}
