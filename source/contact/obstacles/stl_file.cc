#include <stiction/base/errors.h>
#include <stiction/base/text/read_line.h>
#include <stiction/contact/obstacles/stl_file.h>

#include <deal.II/base/tensor.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

namespace stiction
{
  namespace
  {
    using dealii::Point;
    using Corners = std::vector<Point<3>>; // three a triangle

    constexpr std::size_t header_size = 84, record_size = 50;

    bool is_binary(const std::string &content)
    {
      if (content.size() < header_size)
        return false;
      std::uint32_t n;
      std::memcpy(&n, content.data() + 80, sizeof(n));
      return content.size() == header_size + record_size * std::size_t(n);
    }

    Corners read_binary(const std::string &content)
    {
      Corners corners;
      for (std::size_t at = header_size; at < content.size(); at += record_size)
        for (unsigned int k = 1; k < 4; ++k) // after the normal
          {
            float x[3];
            std::memcpy(x, content.data() + at + 12 * k, sizeof(x));
            corners.emplace_back(x[0], x[1], x[2]);
          }
      return corners;
    }

    // Throws the reason.
    Corners read_text(const std::string &content)
    {
      std::istringstream in(content);
      std::string line, word;
      Corners corners;
      for (unsigned int number = 1; read_line(in, line); ++number)
        {
          std::istringstream words(line);
          if (!(words >> word))
            continue;
          const auto refuse = [&](const std::string &reason) {
            throw InputError("is no STL file, " + reason + " in line " +
                             std::to_string(number));
          };
          if (word == "vertex")
            {
              Point<3> p;
              if (!(words >> p[0] >> p[1] >> p[2]))
                refuse("a vertex is not three numbers");
              corners.push_back(p);
            }
          else if (word == "endfacet" && corners.size() % 3 != 0)
            refuse("a facet that is no triangle ends");
          else if (word != "solid" && word != "endsolid" && word != "facet" &&
                   word != "endfacet" && word != "outer" && word != "endloop")
            refuse("an unknown word stands");
        }
      if (corners.size() % 3 != 0)
        throw InputError("is no STL file, it ends inside a facet");
      return corners;
    }

    Corners read_corners(const std::string &content)
    {
      if (content.empty())
        throw InputError("is empty");
      if (is_binary(content))
        return read_binary(content);
      const std::size_t first = content.find_first_not_of(" \t\r\n" + byte_order_mark);
      if (first == std::string::npos || content.compare(first, 5, "solid") != 0)
        throw InputError("is no STL file");
      return read_text(content);
    }
  } // namespace

  TriangulatedSurface read_stl(const std::string &file, const std::string &description)
  {
    std::ifstream in(file, std::ios::binary);
    std::string content;
    // a directory opens, but nothing can be read from it
    if (in && (in.peek(), !in.bad()))
      content.assign(std::istreambuf_iterator<char>(in), {});
    if (in.bad() || !in.is_open())
      throw InputError(description + ", the file cannot be read, must be an STL file.");

    Corners corners;
    try
      {
        corners = read_corners(content);
      }
    catch (const InputError &reason)
      {
        throw InputError(description + ", the file " + reason.what() +
                         ", must be an STL file of triangles.");
      }

    TriangulatedSurface surface;
    std::map<std::array<double, 3>, unsigned int> places;
    const auto vertex = [&](const Point<3> &p) {
      for (unsigned int c = 0; c < 3; ++c)
        if (!(std::abs(p[c]) <= 1e30))
          throw InputError(description + ", the file has a vertex that is no point, must "
                                         "have finite coordinates of at most 1e30.");
      const auto place = places.emplace(std::array<double, 3>{{p[0], p[1], p[2]}},
                                        surface.vertices.size());
      if (place.second)
        surface.vertices.push_back(p);
      return place.first->second;
    };
    for (std::size_t t = 0; t < corners.size(); t += 3)
      {
        const Point<3> &a = corners[t], &b = corners[t + 1], &c = corners[t + 2];
        const double area2 = dealii::cross_product_3d(b - a, c - a).norm();
        if (area2 > 1e-12 * (b - a).norm() * (c - a).norm())
          surface.triangles.push_back({{vertex(a), vertex(b), vertex(c)}});
        else
          for (const Point<3> *p : {&a, &b, &c})
            vertex(*p); // refused if it is no point
      }
    if (surface.triangles.empty())
      throw InputError(description + ", the file has no triangle with an area, must have "
                                     "one at least.");
    return surface;
  }
} // namespace stiction
