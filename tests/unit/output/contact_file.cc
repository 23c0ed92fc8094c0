// The contact file carries values, not zeros: read back from the VTU files,
// summed over the nodes and compared with the certificate. Open nodes slip
// too; the slip bound is that of the law; clamped nodes are marked.

#include "physics/several_bodies.h"
#include "vtu_file.h"

#include <deal.II/base/utilities.h>

#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

using namespace stiction;

namespace
{
  // The nodes of a boundary that bears the forces of one pair and lies opposite in
  // another: in the files the forces that it bears are there.
  void bear_and_lie_opposite()
  {
    const std::string prm =
      file("both.prm",
           brick("plate", "3,1,0.5", "12,4,1", "0;0;0") +
             brick("one", "1,1,1", "2,2,2", "0;0;0.5") +
             brick("two", "1,1,1", "3,3,2", "2;0;0.5") +
             section("Boundary conditions",
                     {"Pressure = one.top : 1 | two.top : 2",
                      "Prescribed displacement = plate.bottom : 0; 0; 0"}) +
             section("Contact pair one",
                     {"Boundary = plate.top", "Obstacle = boundary : one.bottom",
                      "Slave side = obstacle", "Law = coulomb", "Coefficient = 0.3"}) +
             section("Contact pair two",
                     {"Boundary = plate.top", "Obstacle = boundary : two.bottom",
                      "Slave side = boundary", "Law = coulomb", "Coefficient = 0.3"}));
    const Run run(prm, {});
    MPI_Barrier(MPI_COMM_WORLD); // the files of the others
    std::map<float, double> forces;
    // a node is in the file once a face
    std::set<std::tuple<float, float, float, float>> seen;
    for (unsigned int r = 0; r < dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
         ++r)
      {
        auto a =
          read_vtu("results/contact." + dealii::Utilities::int_to_string(r, 4) + ".vtu");
        for (std::size_t i = 0; i < a["boundary"].size(); ++i)
          {
            const float boundary = a["boundary"][i], *const x = &a["points"][3 * i];
            if (seen.emplace(boundary, x[0], x[1], x[2]).second)
              forces[boundary] += a["area"][i] * a["pressure"][i];
          }
      }
    std::vector<double> of_contacts;
    for (const auto &part : run.summary()["contact"]["boundaries"])
      of_contacts.push_back(forces[part["id"].get<float>()]);
    out() << "a side that bears one pair and lies opposite in another: certified "
          << yes(run.converged) << ", forces in the files 1 and 2 "
          << yes(of_contacts.size() == 2 && std::abs(of_contacts[0] - 1.) < 1e-5 &&
                 std::abs(of_contacts[1] - 2.) < 1e-5)
          << std::endl;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const std::string law : {"coulomb", "given"})
    {
      const Run run(shipped("brick.prm"),
                    {"Geometry/Table 1 level=2", "Friction/Law=" + law,
                     "Friction/Slip stress=1.5e7", "Friction/Slip stress=1.5e7"});
      MPI_Barrier(MPI_COMM_WORLD); // the files of the others
      if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
        continue;

      double pressure = 0., area = 0., bound_error = 0., open_slip = 0.;
      double parts_error = 0., moved_error = 0.;
      std::array<double, 3> traction{};
      std::map<int, unsigned int> normal, tangential;
      std::map<std::tuple<float, float, float>, bool> seen;
      const unsigned int n_ranks =
        dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
      for (unsigned int r = 0; r < n_ranks; ++r)
        {
          auto a = read_vtu("results/contact." + dealii::Utilities::int_to_string(r, 4) +
                            ".vtu");
          for (std::size_t i = 0; i < a["normal_status"].size(); ++i)
            {
              const auto place = std::make_tuple(
                a["points"][3 * i], a["points"][3 * i + 1], a["points"][3 * i + 2]);
              if (!seen.emplace(place, true).second)
                continue; // a node is in the file once a face
              const float here = a["area"][i];
              ++normal[static_cast<int>(a["normal_status"][i])];
              ++tangential[static_cast<int>(a["tangential_status"][i])];
              area += here;
              pressure += here * a["pressure"][i];
              for (unsigned int c = 0; c < 3; ++c)
                traction[c] += here * a["traction"][3 * i + c];
              if (a["normal_status"][i] == 0.f)
                open_slip = std::max<double>(
                  open_slip, std::hypot(a["slip"][3 * i], a["slip"][3 * i + 1]));
              // the parts of the traction along the normal and across it
              float normal_part = 0.f, across = 0.f, length = 0.f;
              for (unsigned int c = 0; c < 3; ++c)
                {
                  const float n = a["normal"][3 * i + c];
                  const float t = a["tangential_traction"][3 * i + c];
                  length += n * n;
                  across += n * t;
                  normal_part += n * a["traction"][3 * i + c];
                  parts_error =
                    std::max<double>(parts_error, std::abs(a["traction"][3 * i + c] +
                                                           a["pressure"][i] * n - t) /
                                                    1.5e7);
                }
              if (a["normal_status"][i] >= 0.f)
                parts_error = std::max<double>(
                  {parts_error, std::abs(length - 1.), std::abs(across) / 1.5e7,
                   std::abs(normal_part + a["pressure"][i]) / 1.5e7});
              // the foundation is at z = 0: the gap is what is left
              if (a["normal_status"][i] >= 0.f)
                moved_error = std::max<double>(
                  moved_error,
                  std::abs(a["displacement"][3 * i + 2] - a["gap"][i]) / 1e-4);
              if (a["normal_status"][i] >= 0.f)
                bound_error = std::max<double>(
                  bound_error,
                  std::abs(a["slip_bound"][i] -
                           (law == "given" ? 1.5e7f : 0.3f * a["pressure"][i])) /
                    1.5e7);
            }
        }

      const auto &contact = run.summary()["contact"];
      bool forces         = true;
      for (unsigned int c = 0; c < 3; ++c)
        forces =
          forces && std::abs(traction[c] - contact["force_on_body"][c].get<double>()) <
                      1e-5 * contact["normal_force"].get<double>();
      out() << law << ": nodes in the file " << seen.size() << ", clamped " << normal[-1]
            << ", pressure sums to the force "
            << yes(std::abs(pressure - contact["normal_force"].get<double>()) <
                   1e-5 * pressure)
            << ", tractions to the resultant " << yes(forces) << ", states as counted "
            << yes(normal[0] == contact["open"] && normal[1] == contact["closed"] &&
                   normal[3] == contact["undecided_normal"] &&
                   tangential[1] == contact["slip"] &&
                   tangential[2] == contact["stick"] &&
                   tangential[3] == contact["undecided_tangential"] &&
                   tangential[-1] == normal[-1] && normal[0] > 0 &&
                   tangential[0] == (law == "given" ? 0 : normal[0]))
            // with given friction they are held at their bound, too
            << ", open nodes slip " << (law == "given" || open_slip > 1e-6 ? "yes" : "NO")
            << ", slip bound of the law " << yes(bound_error < 1e-5)
            << ", normal and tangential parts " << yes(parts_error < 1e-5)
            << ", displaced to the gap " << yes(moved_error < 1e-5) << ", area " << area
            << std::endl;
    }
  bear_and_lie_opposite();
}
