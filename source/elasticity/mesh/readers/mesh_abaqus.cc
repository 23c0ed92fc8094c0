#include "mesh_builder.h"

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <set>

namespace stiction
{
  namespace
  {
    using dealii::Utilities::split_string_list;
    using dealii::Utilities::trim;

    bool begins_with_any(const std::string &text,
                         const std::vector<std::string> &beginnings)
    {
      return std::any_of(
        beginnings.begin(), beginnings.end(),
        [&](const std::string &beginning) { return text.rfind(beginning, 0) == 0; });
    }

    // The type that Gmsh has for it and how many nodes it has, which is what
    // its name says; 0 if it is none. Other letters, as for reduced integration,
    // say nothing of the shape.
    std::pair<std::int64_t, unsigned int> type_of_cell(const std::string &type)
    {
      static const std::map<unsigned int, std::int64_t> types = {
        {4, 4}, {6, 6}, {8, 5}, {10, 11}, {15, 18}, {20, 17}, {27, 12}};
      for (const auto &[n_nodes, gmsh_type] : types)
        {
          const std::string name = "C3D" + std::to_string(n_nodes);
          if (type == name ||
              begins_with_any(type, {name + 'R', name + 'I', name + 'H', name + 'M'}))
            return {gmsh_type, n_nodes};
        }
      return {0, 0};
    }

    const std::string understood = "tetrahedra (C3D4, C3D10), prisms (C3D6, C3D15) or "
                                   "hexahedra (C3D8, C3D20, C3D27)";

    // The faces S1, S2, ... of Abaqus' manual, by the numbers of deal.II's vertices.
    const std::vector<std::vector<unsigned int>> &faces_of(const std::size_t n_vertices)
    {
      static const std::map<std::size_t, std::vector<std::vector<unsigned int>>> faces = {
        {4, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}},
        {6, {{0, 1, 2}, {3, 5, 4}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}},
        {8,
         {{0, 1, 5, 4},
          {2, 6, 7, 3},
          {0, 2, 3, 1},
          {1, 3, 7, 5},
          {5, 7, 6, 4},
          {4, 6, 2, 0}}}};
      return faces.at(n_vertices);
    }

    // deal.II's GridIn takes ids from the digits in names, element n to be the
    // n-th, and nine digits of coordinates.
    // What it takes from an input file: *NODE, *ELEMENT, *ELSET, *SURFACE and
    // *SOLID SECTION; other keywords are passed over. Words are not case
    // sensitive; names appear as they are written first.
    class AbaqusReader
    {
    public:
      explicit AbaqusReader(TextScanner &text)
        : text_(text)
        , mesh_(text)
      {
      }

      MeshData read()
      {
        std::string line;
        while (text_.next_line(line))
          {
            if (line.empty() || line.rfind("**", 0) == 0)
              continue;
            if (line[0] == '*')
              read_keyword(line);
            else if (keyword_.empty())
              text_.refuse("is not an Abaqus input file, which begins with a "
                           "keyword such as '*HEADING'");
            else
              read_data(line);
          }
        end_of_data();
        if (mesh_.is_of_cells())
          {
            add_surfaces();
            name_materials();
          }
        return mesh_.finish();
      }

    private:
      void read_keyword(const std::string &line)
      {
        end_of_data();
        keyword_ = "";
        options_.clear();
        for (const std::string &item : split_string_list(line))
          if (keyword_.empty())
            keyword_ = upper(item);
          else
            {
              const std::size_t equals = item.find('=');
              std::string value =
                equals == std::string::npos ? "" : trim(item.substr(equals + 1));
              if (value.size() > 1 && value.front() == '"' && value.back() == '"')
                value = value.substr(1, value.size() - 2);
              options_[upper(trim(item.substr(0, equals)))] = value;
            }
        if (keyword_ == "*SURFACE")
          {
            const std::string type = upper(options_["TYPE"]);
            if (!type.empty() && type != "ELEMENT")
              keyword_ = "*IGNORED";
            else
              surfaces_.push_back({options_["NAME"], {}});
          }
        else if (keyword_ == "*PART")
          ++n_parts_;
        else if (keyword_ == "*SOLID SECTION")
          sections_.push_back({options_["ELSET"], options_["MATERIAL"]});
        else if (keyword_ == "*INCLUDE" ||
                 (keyword_ == "*NODE" && options_.count("INPUT") != 0) ||
                 (keyword_ == "*ELEMENT" && options_.count("INPUT") != 0))
          text_.refuse("another file is included, must be one file");
      }

      void read_data(const std::string &line)
      {
        // an element may go on after a ',' at the end of a line
        if (keyword_ == "*ELEMENT")
          {
            unfinished_ += line;
            if (line.back() == ',')
              return;
            read_element(split_string_list(unfinished_));
            unfinished_.clear();
            return;
          }
        const std::vector<std::string> items = split_string_list(line);
        if (keyword_ == "*NODE")
          read_node(items);
        else if (keyword_ == "*ELSET")
          read_set(items);
        else if (keyword_ == "*SURFACE")
          {
            if (items.size() != 2)
              text_.refuse("'" + line.substr(0, 40) +
                           "' is no part of a surface, must be an element or "
                           "a set and a face from S1 to S6");
            surfaces_.back().parts.push_back({items[0], face_number(items[1])});
          }
        else if (keyword_ == "*INSTANCE")
          text_.refuse("the instance is moved, must stand where its part does");
      }

      void end_of_data()
      {
        if (!unfinished_.empty())
          text_.refuse("an element is not complete before this line");
      }

      void read_node(const std::vector<std::string> &items)
      {
        if (items.size() < 4 || std::count(items.begin() + 1, items.begin() + 4, "") > 0)
          text_.refuse("a node with its number and three coordinates should "
                       "stand here");
        const std::int64_t number = text_.to_integer(items[0]);
        if (n_parts_ > 1 && mesh_.has_node(number))
          text_.refuse("node " + items[0] +
                       " stands in two parts, each '*PART' must be a "
                       "file of its own; sections 'Body' join them");
        mesh_.add_node(number, {text_.to_real(items[1]), text_.to_real(items[2]),
                                text_.to_real(items[3])});
      }

      void read_element(const std::vector<std::string> &items)
      {
        const std::string type = upper(options_["TYPE"]);
        if (const auto [gmsh_type, n_nodes] = type_of_cell(type); n_nodes > 0)
          {
            if (items.size() != n_nodes + 1)
              text_.refuse(
                "an element with its number and " + std::to_string(n_nodes) +
                " nodes should stand here, not " + std::to_string(items.size() - 1) +
                " nodes, as it is of type " + type + "; understood are " + understood);
            const std::int64_t number = text_.to_integer(items[0]);
            if (!cells_.emplace(number, mesh_.mesh.cells.size()).second)
              text_.refuse("element " + items[0] + " stands twice, must stand once");
            MeshBuilder::Nodes nodes;
            for (unsigned int i = 1; i <= n_nodes; ++i)
              nodes.push_back(text_.to_integer(items[i]));
            // nodes inside of a hexahedron: the centre, then faces S1 to S6
            mesh_.add_element(gmsh_type, 0,
                              in_gmsh_order(nodes, {{21, 23, 26, 24, 25, 22, 20}}));
            add_to_set(options_["ELSET"], number);
            if (!options_["ELSET"].empty())
              element_sets_.insert(upper(options_["ELSET"]));
          }
        else if (begins_with_any(type, {"C3D5", "C3D13"}))
          ++mesh_.mesh.other_elements["pyramids"];
        else if (begins_with_any(type, {"C3D"}))
          text_.refuse("has elements of type " + type + ", must be " + understood);
        else if (!begins_with_any(type, {"T3D", "B3", "SPRING", "MASS"}))
          // those are no part of a body, written for its edges
          ++mesh_.mesh.other_elements["elements of type " + type];
      }

      void add_to_set(const std::string &set, const std::int64_t element)
      {
        if (set.empty())
          return;
        names_.emplace(upper(set), set);
        sets_[upper(set)].push_back(element);
      }

      void read_set(const std::vector<std::string> &items)
      {
        const std::string &set = options_["ELSET"];
        if (set.empty())
          text_.refuse("a set without a name, must be '*ELSET, ELSET=name'");
        if (options_.count("GENERATE") != 0)
          {
            if (items.size() < 2)
              text_.refuse("the first and the last element should stand here");
            const std::int64_t first = text_.to_integer(items[0]);
            const std::int64_t last  = text_.to_integer(items[1]);
            const std::int64_t step =
              items.size() > 2 && !items[2].empty() ? text_.to_integer(items[2]) : 1;
            // no mesh has so many elements, nor larger numbers of them
            constexpr std::int64_t largest = 10000000000, most = 20000000;
            if (step < 1 || std::abs(first) > largest || std::abs(last) > largest ||
                (last - first) / step >= most)
              text_.refuse("the elements from " + items[0] + " to " + items[1] +
                           " in steps of " + std::to_string(step) +
                           " are too many, or no set, must be at most 20000000");
            for (std::int64_t e = first; e <= last; e += step)
              add_to_set(set, e);
            return;
          }
        for (const std::string &item : items)
          if (item.empty())
            continue;
          else if (sets_.count(upper(item)) != 0)
            for (const std::int64_t e : std::vector<std::int64_t>(sets_.at(upper(item))))
              add_to_set(set, e);
          else
            add_to_set(set, text_.to_integer(item));
      }

      unsigned int face_number(const std::string &face) const
      {
        if (face.size() != 2 || (face[0] != 'S' && face[0] != 's') || face[1] < '1' ||
            face[1] > '6')
          text_.refuse("'" + face.substr(0, 40) +
                       "' is no face of an element, must be from S1 to S6");
        return static_cast<unsigned int>(face[1] - '1');
      }

      void add_surfaces()
      {
        unsigned int id = 0;
        for (const Surface &surface : surfaces_)
          {
            mesh_.add_name(surface.name, ++id, mesh_.mesh.boundary_names);
            for (const auto &part : surface.parts)
              for (const std::int64_t element : elements(part.first))
                {
                  const auto &of_cell = cell(element).vertices;
                  const auto &faces   = faces_of(of_cell.size());
                  if (part.second >= faces.size())
                    text_.refuse("element " + std::to_string(element) + " is a " +
                                 kind_of_cell(of_cell.size()) + " and has no face S" +
                                 std::to_string(part.second + 1) +
                                 ", must be from S1 to S" + std::to_string(faces.size()));
                  std::vector<unsigned int> vertices;
                  for (const unsigned int v : faces[part.second])
                    vertices.push_back(of_cell[v]);
                  mesh_.add_face(id, vertices);
                }
          }
      }

      void name_materials()
      {
        if (sections_.empty())
          for (const std::string &set : element_sets_)
            sections_.push_back({set, names_.at(set)});
        unsigned int last = 0;
        std::map<std::string, unsigned int> ids;
        for (const auto &section : sections_)
          {
            const auto id = ids.emplace(upper(section.second), last + 1);
            if (id.second)
              mesh_.add_name(section.second, ++last, mesh_.mesh.material_names);
            for (const std::int64_t element : elements(section.first))
              {
                unsigned int &material = cell(element).material_id;
                if (material != 0 && material != id.first->second)
                  text_.refuse("element " + std::to_string(element) +
                               " has two materials, must have one");
                material = id.first->second;
              }
          }
      }

      // Of a set, or the one with the number.
      std::vector<std::int64_t> elements(const std::string &what) const
      {
        const auto set = sets_.find(upper(what));
        if (set != sets_.end())
          return set->second;
        if (what.empty() || what.find_first_not_of("0123456789") != std::string::npos)
          text_.refuse("there is no set of elements '" + what.substr(0, 40) + "'");
        return {text_.to_integer(what)};
      }

      dealii::CellData<3> &cell(const std::int64_t element)
      {
        const auto found = cells_.find(element);
        if (found == cells_.end())
          text_.refuse("there is no element " + std::to_string(element));
        return mesh_.mesh.cells[found->second];
      }

      struct Surface
      {
        std::string name;
        // elements or sets, and the face of each
        std::vector<std::pair<std::string, unsigned int>> parts;
      };

      TextScanner &text_;
      MeshBuilder mesh_;
      // by their numbers, where they are in the mesh
      std::unordered_map<std::int64_t, std::size_t> cells_;

      unsigned int n_parts_ = 0;
      std::string keyword_, unfinished_;
      std::map<std::string, std::string> options_;

      std::vector<Surface> surfaces_;
      std::vector<std::pair<std::string, std::string>> sections_;
      std::map<std::string, std::vector<std::int64_t>> sets_;
      std::map<std::string, std::string> names_; // of sets, as written
      std::set<std::string> element_sets_;       // those of *ELEMENT
    };
  } // namespace

  MeshData read_abaqus(TextScanner &text)
  {
    return AbaqusReader(text).read();
  }
} // namespace stiction
