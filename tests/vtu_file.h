#pragma once

// What stands in the VTU files of deal.II.

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <zlib.h>

// The floating point numbers of one DataArray: base64 of a header (number
// of blocks, block size, size of the last one, compressed sizes) and of the
// compressed blocks.
inline std::vector<float> decode(const std::string &text)
{
  const auto head = dealii::Utilities::decode_base64(text.substr(0, 24));
  std::uint32_t header[4];
  std::memcpy(header, head.data(), sizeof(header));
  const auto body = dealii::Utilities::decode_base64(text.substr(24));
  uLongf size     = header[0] == 0 ? 0 : header[1];
  std::vector<float> values(size / sizeof(float));
  uncompress(reinterpret_cast<Bytef *>(values.data()), &size, body.data(), body.size());
  return values;
}

// The arrays of a file by name, the places as "points".
inline std::map<std::string, std::vector<float>> read_vtu(const std::string &file)
{
  std::ifstream in(file);
  std::stringstream content;
  content << in.rdbuf();
  const std::string text = content.str();

  std::map<std::string, std::vector<float>> arrays;
  const auto between = [&](const std::string &from, const char *to,
                           const std::string &in) {
    const std::size_t at = in.find(from);
    return at == std::string::npos
             ? std::string()
             : in.substr(at + from.size(),
                         in.find(to, at + from.size()) - at - from.size());
  };
  const std::string begin = "<DataArray type=\"Float";
  for (std::size_t at = text.find(begin); at != std::string::npos;
       at             = text.find(begin, at + 1))
    {
                  const std::size_t end        = text.find('>', at);
                  const std::string attributes = text.substr(at, end - at);
                  std::string values           = text.substr(end + 1, text.find('<', end) - end - 1);
                  values.erase(std::remove_if(values.begin(), values.end(), ::isspace), values.end());
                  const std::string name                 = between("Name=\"", "\"", attributes);
                  arrays[name.empty() ? "points" : name] = decode(values);
    }
  return arrays;
}
