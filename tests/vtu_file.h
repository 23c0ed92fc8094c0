#ifndef stiction_tests_vtu_file_h
#define stiction_tests_vtu_file_h

// What stands in the VTU files of deal.II.

#include <deal.II/base/utilities.h>

#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <zlib.h>

// The floating point numbers of one DataArray: base64 of a header (number
// of blocks, block size, size of the last one, compressed sizes) and of the
// compressed blocks.
inline std::vector<float>
decode(const std::string &text)
{
  const auto head = dealii::Utilities::decode_base64(text.substr(0, 24));
  std::uint32_t header[4];
  std::memcpy(header, head.data(), sizeof(header));
  const auto body = dealii::Utilities::decode_base64(text.substr(24));
  uLongf size     = header[0] == 0 ? 0 : header[1];
  std::vector<float> values(size / sizeof(float));
  uncompress(
    reinterpret_cast<Bytef *>(values.data()), &size, body.data(), body.size());
  return values;
}

// The arrays of a file by name, the places as "points".
inline std::map<std::string, std::vector<float>>
read_vtu(const std::string &file)
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

#endif
