// The contact file carries values, not zeros: read back from the VTU files,
// summed over the nodes and compared with the certificate. Open nodes slip
// too; the slip bound is that of the law; clamped nodes are marked.

#include "tests.h"

#include <deal.II/base/utilities.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <regex>
#include <tuple>

#include <array>

#include <zlib.h>

using namespace stiction;

namespace
{
  // The floating point numbers of one DataArray: base64 of a header (number
  // of blocks, block size, size of the last one, compressed sizes) and of the
  // compressed blocks.
  std::vector<float>
  decode(const std::string &text)
  {
    const auto head = dealii::Utilities::decode_base64(text.substr(0, 24));
    std::uint32_t header[4];
    std::memcpy(header, head.data(), sizeof(header));
    const auto body = dealii::Utilities::decode_base64(text.substr(24));
    uLongf size     = header[0] == 0 ? 0 : header[1];
    std::vector<float> values(size / sizeof(float));
    uncompress(reinterpret_cast<Bytef *>(values.data()),
               &size,
               body.data(),
               body.size());
    return values;
  }

  std::map<std::string, std::vector<float>>
  read(const std::string &file)
  {
    std::ifstream in(file);
    std::stringstream content;
    content << in.rdbuf();
    std::string text = content.str();

    std::map<std::string, std::vector<float>> arrays;
    const std::regex array(
      "<DataArray type=\"Float(?:32|64)\"([^>]*)>\\s*([A-Za-z0-9+/=]*)\\s*"
      "</DataArray>");
    for (std::sregex_iterator i(text.begin(), text.end(), array), end; i != end;
         ++i)
      {
        const std::string attributes = (*i)[1];
        std::smatch name;
        arrays[std::regex_search(
                 attributes, name, std::regex("Name=\"([^\"]*)\""))
                 ? std::string(name[1])
                 : "points"] = decode((*i)[2]);
      }
    return arrays;
  }
} // namespace



int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const std::string law : {"coulomb", "given"})
    {
      const Run run(shipped("brick.prm"),
                    {"Geometry/Table 1 level=2",
                     "Friction/Law=" + law,
                     "Friction/Slip stress=1.5e7",
                     "Friction/Slip stress=1.5e7"});
      MPI_Barrier(MPI_COMM_WORLD); // the files of the others
      if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
        continue;

      double pressure = 0., area = 0., bound_error = 0., open_slip = 0.;
      std::array<double, 3> traction{};
      std::map<int, unsigned int> status;
      std::map<std::tuple<float, float, float>, bool> seen;
      const unsigned int n_ranks =
        dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
      for (unsigned int r = 0; r < n_ranks; ++r)
        {
          auto a = read("results/contact." +
                        dealii::Utilities::int_to_string(r, 4) + ".vtu");
          for (std::size_t i = 0; i < a["status"].size(); ++i)
            {
              const auto place = std::make_tuple(a["points"][3 * i],
                                                 a["points"][3 * i + 1],
                                                 a["points"][3 * i + 2]);
              if (!seen.emplace(place, true).second)
                continue; // a node is in the file once a face
              const float here = a["area"][i];
              ++status[static_cast<int>(a["status"][i])];
              area += here;
              pressure += here * a["pressure"][i];
              for (unsigned int c = 0; c < 3; ++c)
                traction[c] += here * a["traction"][3 * i + c];
              if (a["status"][i] == 0.f)
                open_slip = std::max<double>(
                  open_slip,
                  std::hypot(a["slip"][3 * i], a["slip"][3 * i + 1]));
              if (a["status"][i] >= 0.f)
                bound_error = std::max<double>(
                  bound_error,
                  std::abs(a["slip_bound"][i] - (law == "given"
                                                   ? 1.5e7f
                                                   : 0.3f * a["pressure"][i])) /
                    1.5e7);
            }
        }

      const auto &contact = run.summary()["contact"];
      bool forces         = true;
      for (unsigned int c = 0; c < 3; ++c)
        forces = forces && std::abs(traction[c] -
                                    contact["force_on_body"][c].get<double>()) <
                             1e-5 * contact["normal_force"].get<double>();
      out() << law << ": nodes in the file " << seen.size() << ", clamped "
            << status[-1] << ", pressure sums to the force "
            << yes(std::abs(pressure - contact["normal_force"].get<double>()) <
                   1e-5 * pressure)
            << ", tractions to the resultant " << yes(forces)
            << ", states as counted "
            << yes(status[0] == contact["open"] &&
                   status[1] == contact["slip"] &&
                   status[2] == contact["stick"])
            // with given friction they are held at their bound, too
            << ", open nodes slip "
            << (law == "given" || open_slip > 1e-6 ? "yes" : "NO")
            << ", slip bound of the law " << yes(bound_error < 1e-5)
            << ", area " << area << std::endl;
    }
}
