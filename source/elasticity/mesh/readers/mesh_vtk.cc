#include "mesh_builder.h"

#include <algorithm>
#include <array>
#include <sstream>

namespace stiction
{
  namespace
  {
    // VTK's legacy format, versions 2 to 5.1, data set UNSTRUCTURED_GRID. Of
    // these deal.II's GridIn reads version 3.0 alone, without fields, cells
    // before faces.
    class VtkReader
    {
    public:
      explicit VtkReader(TextScanner &text)
        : text_(text)
        , mesh_(text)
      {
      }

      MeshData read()
      {
        read_header();
        std::string line;
        while (text_.next_line(line))
          if (!line.empty())
            read_section(line);
        make_elements();
        return mesh_.finish();
      }

    private:
      void read_header()
      {
        std::string line;
        if (!text_.next_line(line) || line.rfind("# vtk DataFile", 0) != 0)
          text_.refuse("is not a legacy VTK file, which begins with '# vtk DataFile'");
        text_.next_line(line); // the title
        if (!text_.next_line(line) || upper(line) != "ASCII")
          text_.refuse("is a binary file, must be text ('ASCII')");
        if (upper(text_.word()) != "DATASET" ||
            upper(text_.word()) != "UNSTRUCTURED_GRID")
          text_.refuse("is no unstructured grid, must be 'DATASET UNSTRUCTURED_GRID'");
        text_.rest_of_line();
      }

      void read_section(const std::string &line)
      {
        std::istringstream words(line);
        std::array<std::string, 4> header;
        for (std::string &word : header)
          words >> word;
        const std::string name = upper(header[0]);
        if (name == "POINTS")
          read_points(text_.to_count(header[1]));
        else if (name == "CELLS")
          read_cells(text_.to_count(header[1]), text_.to_count(header[2]));
        else if (name == "CELL_TYPES")
          for (const std::int64_t type : text_.integers(text_.to_count(header[1])))
            types_.push_back(type);
        else if (name == "CELL_DATA" || name == "POINT_DATA")
          {
            n_data_       = text_.to_count(header[1]);
            is_cell_data_ = name == "CELL_DATA";
          }
        else if (name == "SCALARS")
          {
            const std::uint64_t n_components =
              header[3].empty() ? 1 : text_.to_count(header[3]);
            if (upper(text_.word()) != "LOOKUP_TABLE")
              text_.refuse("'LOOKUP_TABLE' should stand here");
            text_.rest_of_line();
            read_array(header[1], n_components * n_data_);
          }
        else if (name == "FIELD")
          for (std::uint64_t n = text_.to_count(header[2]); n > 0; --n)
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
          read_array("", 4 * text_.to_count(header[2]));
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

      void read_points(const std::uint64_t n)
      {
        for (std::uint64_t i = 0; i < n; ++i)
          mesh_.add_node(static_cast<std::int64_t>(i),
                         {text_.real(), text_.real(), text_.real()});
      }

      // "CELLS n size" and rows "n_vertices v v ..."; from 5.1 on "CELLS n + 1
      // size" and the arrays OFFSETS and CONNECTIVITY.
      void read_cells(const std::uint64_t n, const std::uint64_t size)
      {
        const std::string first = n > 0 ? text_.word() : "";
        if (upper(first) != "OFFSETS")
          {
            for (std::uint64_t i = 0; i < n; ++i)
              {
                const std::uint64_t n_vertices =
                  i == 0 ? text_.to_count(first) : text_.count();
                if (n_vertices == 0)
                  text_.refuse("a cell without nodes stands here, must begin with how "
                               "many it has, or 'OFFSETS' must stand right below "
                               "'CELLS', as files of version 5.1 have it");
                cells_.push_back(text_.integers(n_vertices));
              }
            return;
          }
        text_.skip(1); // the type of the numbers
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
        text_.skip(1);
        for (std::uint64_t i = 0; i + 1 < n; ++i)
          cells_.push_back(text_.integers(offsets[i + 1] - offsets[i]));
      }

      void read_array(const std::string &name, const std::uint64_t n)
      {
        if (is_cell_data_ && name == "MaterialID")
          {
            ids_.clear();
            for (std::uint64_t i = 0; i < n; ++i)
              {
                const double id = text_.real();
                // no integer has more digits; to_id() refuses what is left
                ids_.push_back(static_cast<std::int64_t>(std::clamp(id, -1e15, 1e15)));
              }
          }
        else
          text_.skip(n);
      }

      void make_elements()
      {
        if (cells_.size() != types_.size() ||
            (!ids_.empty() && ids_.size() != cells_.size()))
          text_.refuse("has " + std::to_string(cells_.size()) + " cells, " +
                       std::to_string(types_.size()) + " cell types and " +
                       std::to_string(ids_.size()) +
                       " numbers 'MaterialID', must be as many of each");
        // what Gmsh numbers them; the others are of no use
        static const std::map<std::int64_t, std::int64_t> types = {
          {5, 2},   {9, 3},   {10, 4},  {12, 5},  {13, 6},  {14, 7},  {22, 9}, {23, 16},
          {24, 11}, {25, 17}, {26, 18}, {27, 19}, {28, 10}, {29, 12}, {32, 13}};
        for (std::size_t i = 0; i < cells_.size(); ++i)
          {
            // deal.II writes -1 for what has no number
            const std::int64_t id = ids_.empty() ? 0 : ids_[i];
            const bool is_face    = types_[i] == 5 || types_[i] == 9;
            if (types.count(types_[i]) == 1 && !(is_face && id == -1))
              mesh_.add_element(types.at(types_[i]), id == -1 ? 0 : id,
                                in_gmsh_order(cells_[i], {{24, 22, 20, 21, 23, 25, 26}}));
            else if (types_[i] < 1 || (types_[i] > 4 && !is_face && types_[i] != 21))
              text_.refuse("has cells of VTK's type " + std::to_string(types_[i]) +
                           ", must be tetrahedra of type 10 or 24, prisms of type "
                           "13, 26 or 32, or hexahedra of type 12, 25 or 29");
          }
      }

      TextScanner &text_;
      MeshBuilder mesh_;
      std::vector<MeshBuilder::Nodes> cells_;
      std::vector<std::int64_t> types_, ids_;
      std::uint64_t n_data_ = 0;
      bool is_cell_data_    = false;
    };
  } // namespace

  MeshData read_vtk(TextScanner &text) { return VtkReader(text).read(); }
} // namespace stiction
