#include "abaqus_elements.h"
#include "abaqus_parts.h"
#include "mesh_builder.h"

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <set>
#include <utility>

namespace stiction
{
  namespace
  {
    using dealii::Utilities::split_string_list;

    // deal.II's GridIn takes ids from the digits in names, element n to be the
    // n-th, and nine digits of coordinates.
    // What it takes from an input file: *NODE, *ELEMENT, *ELSET, *SURFACE,
    // *SOLID SECTION, *PART and *INSTANCE; other keywords are passed over. Words are not
    // case sensitive; names appear as they are written first.
    class AbaqusReader
    {
    public:
      explicit AbaqusReader(TextScanner &text)
        : text_(text)
        , mesh_(text)
        , parts_(text)
        , cells_(1)
      {
      }

      MeshData read()
      {
        read_until("");
        end_of_data();
        const TextScanner::Place end = text_.here();
        if (mesh_.is_of_cells())
          {
            add_surfaces();
            name_materials();
          }
        text_.go_to(end);
        return mesh_.finish();
      }

    private:
      // Numbers and names of an instance count within it, or in the whole file.
      struct Scope
      {
        std::size_t number = 0; // in cells_
        std::string prefix;     // of names
      };

      // An element by its number in a scope.
      struct Element
      {
        std::size_t scope;
        std::int64_t number;
      };

      // An element or a set as it is written somewhere.
      struct Reference
      {
        std::string what;
        Scope scope;
        TextScanner::Place place; // behind it
      };

      struct Surface
      {
        std::string name;
        std::vector<std::pair<Reference, unsigned int>> parts; // with the face of each
      };

      // Reads up to a keyword, or the end of the file.
      void read_until(const std::string &last)
      {
        std::string line;
        while (text_.next_line(line))
          {
            if (line.empty() || line.rfind("**", 0) == 0)
              continue;
            if (line[0] == '*')
              {
                read_keyword(line);
                if (keyword_.name == last)
                  return;
              }
            else if (keyword_.name.empty())
              text_.refuse("is not an Abaqus input file, which begins with a "
                           "keyword such as '*HEADING'");
            else
              read_data(line);
          }
      }

      void read_keyword(const std::string &line)
      {
        end_of_data();
        keyword_ = AbaqusKeyword(line);
        if (keyword_.name == "*SURFACE")
          {
            const std::string type = upper(keyword_.value("TYPE"));
            if (!type.empty() && type != "ELEMENT")
              keyword_.name = "*IGNORED";
            else
              surfaces_.push_back({scope_.prefix + keyword_.value("NAME"), {}});
          }
        else if (keyword_.name == "*INSTANCE")
          {
            begin_instance(keyword_.value("NAME"));
            part_ = keyword_.value("PART");
          }
        else if (keyword_.name == "*PART" && parts_.have_instances())
          skip_part();
        else if (keyword_.name == "*PART")
          begin_instance(keyword_.value("NAME"));
        else if (keyword_.name == "*END INSTANCE" ||
                 (keyword_.name == "*END PART" && !parts_.have_instances()))
          begin({});
        else if (keyword_.name == "*SOLID SECTION")
          sections_.emplace_back(refer_to(keyword_.value("ELSET"), scope_),
                                 keyword_.value("MATERIAL"));
        else if (keyword_.name == "*INCLUDE" ||
                 (keyword_.name == "*NODE" && keyword_.has("INPUT")) ||
                 (keyword_.name == "*ELEMENT" && keyword_.has("INPUT")))
          text_.refuse("another file is included, must be one file");
      }

      void begin_instance(const std::string &name)
      {
        Scope scope;
        if (parts_.are_several())
          {
            scope = {cells_.size(), name + "."};
            cells_.emplace_back();
          }
        if (!scopes_.emplace(upper(name), scope).second)
          text_.refuse("instance '" + name +
                       "' stands twice, must have a name of its own");
        begin(scope);
      }

      void begin(const Scope &scope)
      {
        scope_     = scope;
        placement_ = {};
        if (parts_.are_several())
          mesh_.forget_numbers();
      }

      // Instances read it.
      void skip_part()
      {
        std::string line;
        while (text_.next_line(line))
          if (line.rfind("*", 0) == 0 && AbaqusKeyword(line).name == "*END PART")
            return;
      }

      void read_data(const std::string &line)
      {
        // an element may go on after a ',' at the end of a line
        if (keyword_.name == "*ELEMENT")
          {
            unfinished_ += line;
            if (line.back() == ',')
              return;
            read_element(split_string_list(unfinished_));
            unfinished_.clear();
            return;
          }
        const std::vector<std::string> items = split_string_list(line);
        if (keyword_.name == "*NODE")
          read_node(items);
        else if (keyword_.name == "*ELSET")
          read_set(items);
        else if (keyword_.name == "*SURFACE")
          {
            if (items.size() != 2)
              text_.refuse("'" + line.substr(0, 40) +
                           "' is no part of a surface, must be an element or "
                           "a set and a face from S1 to S6");
            surfaces_.back().parts.emplace_back(refer_to(items[0], scope_),
                                                face_number(items[1]));
          }
        else if (keyword_.name == "*INSTANCE")
          placement_.add_line(items, text_);
      }

      void end_of_data()
      {
        if (!unfinished_.empty())
          text_.refuse("an element is not complete before this line");
        if (part_.empty())
          return;
        // the lines that say where the instance stands are read
        const TextScanner::Place here = text_.here();
        text_.go_to(parts_.begin(std::exchange(part_, "")));
        keyword_.name = "*PART";
        read_until("*END PART");
        text_.go_to(here);
      }

      void read_node(const std::vector<std::string> &items)
      {
        if (items.size() < 4 || std::count(items.begin() + 1, items.begin() + 4, "") > 0)
          text_.refuse("a node with its number and three coordinates should "
                       "stand here");
        mesh_.add_node(text_.to_integer(items[0]),
                       placement_({text_.to_real(items[1]), text_.to_real(items[2]),
                                   text_.to_real(items[3])}));
      }

      void read_element(const std::vector<std::string> &items)
      {
        const std::string type = upper(keyword_.value("TYPE"));
        if (const auto [gmsh_type, n_nodes] = abaqus::type_of_cell(type); n_nodes > 0)
          {
            if (items.size() != n_nodes + 1)
              text_.refuse("an element with its number and " + std::to_string(n_nodes) +
                           " nodes should stand here, not " +
                           std::to_string(items.size() - 1) +
                           " nodes, as it is of type " + type + "; understood are " +
                           abaqus::understood_elements);
            const std::int64_t number = text_.to_integer(items[0]);
            if (!cells_[scope_.number].emplace(number, mesh_.mesh.cells.size()).second)
              text_.refuse("element " + items[0] + " stands twice, must stand once");
            MeshBuilder::Nodes nodes;
            for (unsigned int i = 1; i <= n_nodes; ++i)
              nodes.push_back(text_.to_integer(items[i]));
            // nodes inside of a hexahedron: the centre, then faces S1 to S6
            mesh_.add_element(gmsh_type, 0,
                              in_gmsh_order(nodes, {{21, 23, 26, 24, 25, 22, 20}}));
            if (const std::string set = keyword_.value("ELSET"); !set.empty())
              {
                add_to_set(set, {scope_.number, number});
                element_sets_.insert(upper(scope_.prefix + set));
              }
          }
        else if (abaqus::begins_with_any(type, {"C3D5", "C3D13"}))
          ++mesh_.mesh.other_elements["pyramids"];
        else if (abaqus::begins_with_any(type, {"C3D"}))
          text_.refuse("has elements of type " + type + ", must be " +
                       abaqus::understood_elements);
        else if (!abaqus::begins_with_any(type, {"T3D", "B3", "SPRING", "MASS"}))
          // those are no part of a body, written for its edges
          ++mesh_.mesh.other_elements["elements of type " + type];
      }

      void add_to_set(const std::string &set, const Element &element)
      {
        const std::string name = scope_.prefix + set;
        names_.emplace(upper(name), name);
        sets_[upper(name)].push_back(element);
      }

      // Whose numbers the data below the keyword are.
      Scope scope_of_data() const
      {
        const std::string instance = keyword_.value("INSTANCE");
        if (instance.empty())
          return scope_;
        const auto found = scopes_.find(upper(instance));
        if (found == scopes_.end())
          text_.refuse("there is no instance '" + instance + "' above");
        return found->second;
      }

      void read_set(const std::vector<std::string> &items)
      {
        const std::string set = keyword_.value("ELSET");
        if (set.empty())
          text_.refuse("a set without a name, must be '*ELSET, ELSET=name'");
        const Scope scope = scope_of_data();
        if (keyword_.has("GENERATE"))
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
              add_to_set(set, {scope.number, e});
            return;
          }
        for (const std::string &item : items)
          if (item.empty())
            continue;
          else if (const std::vector<Element> *const members = find_set(item, scope))
            for (const Element &element : std::vector<Element>(*members))
              add_to_set(set, element);
          else
            add_to_set(set, {scope.number, text_.to_integer(item)});
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
              for (const Element &element : elements(part.first))
                {
                  const auto &of_cell = cell(element).vertices;
                  const auto &faces   = abaqus::faces_of(of_cell.size());
                  if (part.second >= faces.size())
                    text_.refuse("element " + std::to_string(element.number) + " is a " +
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
            sections_.emplace_back(refer_to(set, {}), names_.at(set));
        unsigned int last = 0;
        std::map<std::string, unsigned int> ids;
        for (const auto &section : sections_)
          {
            const auto id = ids.emplace(upper(section.second), last + 1);
            if (id.second)
              mesh_.add_name(section.second, ++last, mesh_.mesh.material_names);
            for (const Element &element : elements(section.first))
              {
                unsigned int &material = cell(element).material_id;
                if (material != 0 && material != id.first->second)
                  text_.refuse("element " + std::to_string(element.number) +
                               " has two materials, must have one");
                material = id.first->second;
              }
          }
      }

      // What stands on the line that was read last.
      Reference refer_to(const std::string &what, const Scope &scope)
      {
        return {what, scope, text_.here()};
      }

      const std::vector<Element> *find_set(const std::string &name,
                                           const Scope &scope) const
      {
        for (const std::string &prefix : {scope.prefix, std::string()})
          if (const auto set = sets_.find(upper(prefix + name)); set != sets_.end())
            return &set->second;
        return nullptr;
      }

      // Of a set, or the one with the number; whatever is wrong with them is so where
      // they are referred to.
      std::vector<Element> elements(const Reference &reference)
      {
        const auto &[what, scope, place] = reference;
        text_.go_to(place);
        if (const std::vector<Element> *const set = find_set(what, scope))
          return *set;
        if (what.empty() || what.find_first_not_of("0123456789") != std::string::npos)
          text_.refuse("there is no set of elements '" + what.substr(0, 40) + "'");
        return {{scope.number, text_.to_integer(what)}};
      }

      dealii::CellData<3> &cell(const Element &element)
      {
        const auto &cells = cells_[element.scope];
        const auto found  = cells.find(element.number);
        if (found == cells.end())
          text_.refuse("there is no element " + std::to_string(element.number));
        return mesh_.mesh.cells[found->second];
      }

      TextScanner &text_;
      MeshBuilder mesh_;
      const AbaqusParts parts_;
      // where they are in the mesh, by their numbers in each scope
      std::vector<std::unordered_map<std::int64_t, std::size_t>> cells_;

      std::map<std::string, Scope> scopes_; // of instances
      Scope scope_;                         // the present one
      AbaqusPlacement placement_;
      std::string part_; // to be read when it is known where the instance stands

      AbaqusKeyword keyword_;
      std::string unfinished_;

      std::vector<Surface> surfaces_;
      std::vector<std::pair<Reference, std::string>> sections_; // with the material
      std::map<std::string, std::vector<Element>> sets_;
      std::map<std::string, std::string> names_; // of sets, as written
      std::set<std::string> element_sets_;       // those of *ELEMENT
    };
  } // namespace

  MeshData read_abaqus(TextScanner &text)
  {
    return AbaqusReader(text).read();
  }
} // namespace stiction
