#include "mesh_text.h"

#include <algorithm>
#include <cctype>

namespace stiction
{
  namespace
  {
    // VTK's legacy format, versions 2 to 5.1, data set UNSTRUCTURED_GRID.
    class VtkReader
    {
    public:
      explicit VtkReader(MeshText &text)
        : text_(text)
      {
      }

      MeshData
      read()
      {
        read_header();
        std::string line;
        while (text_.next_line(line))
          if (!line.empty())
            read_section(line);
        make_elements();
        return std::move(mesh_);
      }

    private:
      static std::string
      upper(std::string text)
      {
        std::transform(text.begin(), text.end(), text.begin(), [](char c) {
          return static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
        });
        return text;
      }

      static std::vector<std::string>
      words(const std::string &line)
      {
        std::vector<std::string> result(1);
        for (const char c : line)
          if (c != ' ' && c != '\t')
            result.back() += c;
          else if (!result.back().empty())
            result.emplace_back();
        return result;
      }

      void
      read_header()
      {
        std::string line;
        if (!text_.next_line(line) || line.rfind("# vtk DataFile", 0) != 0)
          text_.refuse("is not a legacy VTK file, which begins with '# vtk "
                       "DataFile'");
        text_.next_line(line); // the title
        if (!text_.next_line(line) || upper(line) != "ASCII")
          text_.refuse("is a binary file, must be text ('ASCII')");
        if (upper(text_.word()) != "DATASET" ||
            upper(text_.word()) != "UNSTRUCTURED_GRID")
          text_.refuse("is no unstructured grid, must be 'DATASET "
                       "UNSTRUCTURED_GRID'");
        text_.rest_of_line();
      }

      void
      read_section(const std::string &line)
      {
        std::vector<std::string> header = words(line);
        const std::string name          = upper(header[0]);
        header.resize(5);
        if (name == "POINTS")
          read_points(length(header[1]));
        else if (name == "CELLS")
          read_cells(length(header[1]), length(header[2]));
        else if (name == "CELL_TYPES")
          {
            for (std::uint64_t n = length(header[1]); n > 0; --n)
              types_.push_back(text_.integer());
          }
        else if (name == "CELL_DATA" || name == "POINT_DATA")
          {
            n_data_       = length(header[1]);
            is_cell_data_ = name == "CELL_DATA";
          }
        else if (name == "SCALARS")
          {
            const std::uint64_t n_components =
              header[3].empty() ? 1 : length(header[3]);
            if (upper(text_.word()) != "LOOKUP_TABLE")
              text_.refuse("'LOOKUP_TABLE' should stand here");
            text_.rest_of_line();
            read_array(header[1], n_components * n_data_);
          }
        else if (name == "FIELD")
          for (std::uint64_t n = length(header[2]); n > 0; --n)
            {
              const std::string array          = text_.word();
              const std::uint64_t n_components = text_.count();
              const std::uint64_t n_tuples     = text_.count();
              const std::string type           = text_.word();
              if (type == "string")
                text_.refuse("the field '" + array.substr(0, 40) +
                             "' is of strings, must be of numbers");
              read_array(array, n_components * n_tuples);
            }
        else if (name == "VECTORS" || name == "NORMALS")
          read_array("", 3 * n_data_);
        else if (name == "TENSORS")
          read_array("", 9 * n_data_);
        else if (name == "LOOKUP_TABLE") // colours
          read_array("", 4 * length(header[2]));
        else if (name == "METADATA")
          {
            // ends with an empty line
            std::string skipped;
            while (text_.next_line(skipped) && !skipped.empty())
              ;
          }
        else
          text_.refuse("'" + header[0].substr(0, 40) +
                       "' is not known here, must be 'POINTS', 'CELLS', "
                       "'CELL_TYPES', 'CELL_DATA' or 'POINT_DATA' with "
                       "'SCALARS', 'VECTORS' or 'FIELD'");
      }

      std::uint64_t
      length(const std::string &word) const
      {
        const std::int64_t value = text_.to_integer(word);
        if (value < 0)
          text_.refuse("'" + word + "' stands where a number >= 0 should");
        return static_cast<std::uint64_t>(value);
      }

      void
      read_points(const std::uint64_t n)
      {
        for (std::uint64_t i = 0; i < n; ++i)
          {
            std::array<double, 3> position;
            for (double &x : position)
              x = text_.real();
            mesh_.vertices.push_back(position);
          }
      }

      // "CELLS n size" and rows "n_vertices v v ..."; from 5.1 on "CELLS n + 1
      // size" and the arrays OFFSETS and CONNECTIVITY.
      void
      read_cells(const std::uint64_t n, const std::uint64_t size)
      {
        const std::string first = n > 0 ? text_.word() : "";
        if (upper(first) != "OFFSETS")
          {
            for (std::uint64_t i = 0; i < n; ++i)
              {
                const std::uint64_t n_vertices =
                  i == 0 ? length(first) : text_.count();
                cells_.emplace_back();
                for (std::uint64_t v = 0; v < n_vertices; ++v)
                  cells_.back().push_back(vertex());
              }
            return;
          }
        text_.word(); // the type of the numbers
        std::vector<std::uint64_t> offsets;
        for (std::uint64_t i = 0; i < n; ++i)
          {
            offsets.push_back(text_.count());
            if (i > 0 && offsets[i] < offsets[i - 1])
              text_.refuse("offsets must not fall");
          }
        if (upper(text_.word()) != "CONNECTIVITY" || offsets[0] != 0 ||
            offsets.back() != size)
          text_.refuse("'CONNECTIVITY' should stand here, with as many "
                       "numbers as the offsets say");
        text_.word();
        for (std::uint64_t i = 0; i + 1 < n; ++i)
          {
            cells_.emplace_back();
            for (std::uint64_t v = offsets[i]; v < offsets[i + 1]; ++v)
              cells_.back().push_back(vertex());
          }
      }

      unsigned int
      vertex()
      {
        const std::uint64_t v = text_.count();
        if (v >= mesh_.vertices.size())
          text_.refuse("there is no point " + std::to_string(v));
        return static_cast<unsigned int>(v);
      }

      void
      read_array(const std::string &name, const std::uint64_t n)
      {
        if (is_cell_data_ && name == "MaterialID")
          {
            ids_.clear();
            for (std::uint64_t i = 0; i < n; ++i)
              ids_.push_back(static_cast<std::int64_t>(text_.real()));
          }
        else
          for (std::uint64_t i = 0; i < n; ++i)
            text_.word();
      }

      void
      make_elements()
      {
        if (cells_.size() != types_.size() ||
            (!ids_.empty() && ids_.size() != cells_.size()))
          text_.refuse("has " + std::to_string(cells_.size()) + " cells, " +
                       std::to_string(types_.size()) + " cell types and " +
                       std::to_string(ids_.size()) +
                       " numbers 'MaterialID', must be as many of each");
        for (std::size_t i = 0; i < cells_.size(); ++i)
          {
            const std::vector<unsigned int> &vertices = cells_[i];
            // deal.II writes -1 for what has no number
            const std::int64_t id = ids_.empty() ? 0 : ids_[i];
            if (types_[i] == 12 && vertices.size() == 8)
              {
                MeshData::Cell cell;
                std::copy(
                  vertices.begin(), vertices.end(), cell.vertices.begin());
                cell.material = to_id(id == -1 ? 0 : id, text_);
                mesh_.cells.push_back(cell);
              }
            else if (types_[i] == 9 && vertices.size() == 4)
              {
                MeshData::Face face;
                std::copy(
                  vertices.begin(), vertices.end(), face.vertices.begin());
                if (id == -1)
                  continue;
                face.boundary = to_id(id, text_);
                mesh_.faces.push_back(face);
              }
            else
              note_other(types_[i]);
          }
      }

      void
      note_other(const std::int64_t type)
      {
        switch (type)
          {
            case 1: // points and lines
            case 2:
            case 3:
            case 4:
              break;
            case 5:
              ++mesh_.other_elements["triangles"];
              break;
            case 10:
              ++mesh_.other_elements["tetrahedra"];
              break;
            case 13:
              ++mesh_.other_elements["wedges"];
              break;
            case 14:
              ++mesh_.other_elements["pyramids"];
              break;
            default:
              text_.refuse("has cells of VTK's type " + std::to_string(type) +
                           ", must be linear hexahedra, which have type 12 "
                           "and 8 points");
          }
      }

      MeshText &text_;
      MeshData mesh_;
      std::vector<std::vector<unsigned int>> cells_;
      std::vector<std::int64_t> types_, ids_;
      std::uint64_t n_data_ = 0;
      bool is_cell_data_    = false;
    };
  } // namespace



  MeshData
  read_vtk(MeshText &text)
  {
    return VtkReader(text).read();
  }
} // namespace stiction
