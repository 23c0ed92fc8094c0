#include "../mesh_builder.h"
#include "abaqus_elements.h"
#include "abaqus_keyword.h"
#include "abaqus_parts.h"
#include "abaqus_sets.h"

#include <stiction/base/text/in_words.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace stiction
{
  namespace
  {
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
        , sets_(text)
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
            const auto of_file = std::exchange(mesh_.mesh.faces.boundary_quads, {});
            add_surfaces();
            add_face_sets(of_file);
            name_materials();
          }
        text_.go_to(end);
        if (!passed_over_.empty())
          mesh_.mesh.left_out.push_back(
            listed({passed_over_.begin(), passed_over_.end()}) +
            "; materials, loads and contact stand in the parameter file");
        return mesh_.finish();
      }

    private:
      // Elements as they are referred to somewhere.
      struct Reference
      {
        std::string what;
        AbaqusScope scope;
        TextScanner::Place place; // behind it
      };

      struct Surface
      {
        std::string name;
        AbaqusScope scope;
        TextScanner::Place place;
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
        keyword_                = AbaqusKeyword(line, text_);
        const std::string &name = keyword_.name;
        const std::string type  = upper(keyword_.value("TYPE"));
        if (const std::string more = keyword_.of_the_problem(); !more.empty())
          passed_over_.insert(more);
        if (name == "*SURFACE" && (type.empty() || type == "ELEMENT"))
          surfaces_.push_back({keyword_.value("NAME"), scope_, text_.here(), {}});
        else if (name == "*SURFACE")
          {
            passed_over_.insert("surfaces of nodes");
            keyword_.name = "*IGNORED";
          }
        else if (name == "*INSTANCE")
          begin_instance();
        else if (name == "*PART" && parts_.have_instances())
          skip_to("*ENDPART", text_); // instances read it
        else if (name == "*PART")
          begin(sets_.add_scope(keyword_.value("NAME")));
        else if (name == "*ENDINSTANCE" ||
                 (name == "*ENDPART" && !parts_.have_instances()))
          begin({});
        else if (name == "*SOLIDSECTION")
          sections_.emplace_back(refer_to(keyword_.value("ELSET")),
                                 keyword_.value("MATERIAL"));
        else
          keyword_.require_all_is_here(text_);
      }

      void begin_instance()
      {
        if (keyword_.has("LIBRARY") || keyword_.has("INSTANCE"))
          text_.refuse("an instance is that of another analysis, must be one of a part");
        part_ = keyword_.value("PART");
        begin(sets_.add_scope(keyword_.value("NAME")));
      }

      void begin(const AbaqusScope &scope)
      {
        scope_     = scope;
        placement_ = {};
        cells_.resize(std::max(cells_.size(), scope.number + 1));
        mesh_.mesh.body_names.resize(parts_.are_several() ? cells_.size() : 0);
        if (parts_.are_several() && scope.number > 0)
          mesh_.mesh.body_names[scope.number] = keyword_.value("NAME");
        mesh_.forget_numbers();
      }

      void read_data(const std::string &line)
      {
        // an element may go on after a ',' at the end of a line
        if (keyword_.name == "*ELEMENT")
          {
            unfinished_ += line;
            if (line.back() == ',')
              return;
            read_element(abaqus_items(unfinished_));
            unfinished_.clear();
            return;
          }
        const std::vector<std::string> items = abaqus_items(line);
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
            surfaces_.back().parts.emplace_back(refer_to(items[0]),
                                                abaqus::face_number(items[1], text_));
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
        read_until("*ENDPART");
        text_.go_to(here);
      }

      void read_node(const std::vector<std::string> &items)
      {
        if (items.size() < 4 || std::count(items.begin() + 1, items.begin() + 4, "") > 0)
          text_.refuse("a node with its number and three coordinates should stand here");
        mesh_.add_node(text_.to_integer(items[0]),
                       placement_({text_.to_real(items[1]), text_.to_real(items[2]),
                                   text_.to_real(items[3])}));
      }

      void read_element(const std::vector<std::string> &items)
      {
        const std::string type = upper(keyword_.value("TYPE"));
        if (const auto [gmsh_type, n_nodes] = abaqus::type_of_cell(type); n_nodes > 0)
          {
            const MeshBuilder::Nodes nodes =
              abaqus::nodes_of(items, n_nodes, type, text_);
            const std::int64_t number = text_.to_integer(items[0]);
            if (faces_.count({scope_.number, number}) > 0 ||
                !cells_[scope_.number].emplace(number, mesh_.mesh.cells.size()).second)
              text_.refuse("element " + items[0] + " stands twice, must stand once");
            // nodes inside of a hexahedron: the centre, then faces S1 to S6
            mesh_.add_element(gmsh_type, 0,
                              in_gmsh_order(nodes, {{21, 23, 26, 24, 25, 22, 20}}));
            if (parts_.are_several())
              mesh_.mesh.body_of_cell.push_back(scope_.number);
            if (const std::string set = keyword_.value("ELSET"); !set.empty())
              {
                add_to_set(set, {scope_.number, number});
                element_sets_.try_emplace(upper(scope_.prefix + set), refer_to(set));
              }
          }
        else if (const auto [gmsh_type, n_nodes] = abaqus::type_of_face(type);
                 n_nodes > 0)
          {
            const std::int64_t number = text_.to_integer(items[0]);
            const AbaqusElement element{scope_.number, number};
            if (cells_[scope_.number].count(number) > 0 ||
                !faces_.emplace(element, faces_.size()).second)
              text_.refuse("element " + items[0] + " stands twice, must stand once");
            mesh_.add_element(gmsh_type, 0,
                              abaqus::nodes_of(items, n_nodes, type, text_));
            if (const std::string set = keyword_.value("ELSET"); !set.empty())
              add_to_set(set, element);
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

      void read_set(const std::vector<std::string> &items)
      {
        const std::string set = keyword_.value("ELSET");
        if (set.empty())
          text_.refuse("a set without a name, must be '*ELSET, ELSET=name'");
        // whose numbers the data below the keyword are
        const std::string instance = keyword_.value("INSTANCE");
        const AbaqusScope scope    = instance.empty() ? scope_ : sets_.scope_of(instance);
        if (keyword_.has("GENERATE"))
          for (const std::int64_t number : generated_numbers(items, text_))
            add_to_set(set, {scope.number, number});
        else
          for (const std::string &item : items)
            if (!item.empty())
              for (const AbaqusElement &element : sets_.elements(scope, item))
                add_to_set(set, element);
      }

      void add_to_set(const std::string &set, const AbaqusElement &element)
      {
        sets_.add(scope_, set, element);
        if (faces_.count(element) > 0)
          face_sets_.try_emplace(upper(scope_.prefix + set), refer_to(set));
      }

      void add_surfaces()
      {
        unsigned int id = 0;
        for (const Surface &surface : surfaces_)
          {
            text_.go_to(surface.place);
            mesh_.add_name(name_of(surface), ++id, mesh_.mesh.boundary_names);
            for (const auto &part : surface.parts)
              for (const AbaqusElement &element : elements(part.first))
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

      // As Gmsh writes boundaries. A surface of the same name has their faces, too.
      void add_face_sets(const std::vector<dealii::CellData<2>> &of_file)
      {
        auto &names = mesh_.mesh.boundary_names;
        for (const auto &[key, set] : face_sets_)
          {
            const auto of_set = elements(set);
            const auto known  = names.find(name_of(set));
            const auto id     = known == names.end() ? names.size() + 1 : known->second;
            mesh_.add_name(name_of(set), id, names);
            for (const AbaqusElement &element : of_set)
              if (faces_.count(element) > 0)
                mesh_.add_face(id, of_file[faces_.at(element)].vertices);
          }
      }

      std::string name_of(const Reference &set) const
      {
        return (parts_.are_several() ? set.scope.prefix : "") + set.what;
      }

      // With that of its instance where there are several, or others of this name.
      std::string name_of(const Surface &surface) const
      {
        const auto n =
          std::count_if(surfaces_.begin(), surfaces_.end(), [&](const Surface &other) {
            return upper(other.name) == upper(surface.name);
          });
        return (parts_.are_several() || n > 1 ? surface.scope.prefix : "") + surface.name;
      }

      void name_materials()
      {
        if (sections_.empty())
          for (const auto &[key, set] : element_sets_)
            sections_.emplace_back(set, name_of(set));
        unsigned int last = 0;
        std::map<std::string, unsigned int> ids;
        for (const auto &section : sections_)
          {
            text_.go_to(section.first.place);
            const auto id = ids.emplace(upper(section.second), last + 1);
            if (id.second)
              mesh_.add_name(section.second, ++last, mesh_.mesh.material_names);
            for (const AbaqusElement &element : elements(section.first))
              {
                if (faces_.count(element) > 0)
                  continue;
                unsigned int &material = cell(element).material_id;
                if (material != 0 && material != id.first->second)
                  text_.refuse("element " + std::to_string(element.number) +
                               " has two materials, must have one");
                material = id.first->second;
              }
          }
      }

      // What stands on the line that was read last.
      Reference refer_to(const std::string &what) { return {what, scope_, text_.here()}; }

      // Whatever is wrong with them is so where they are referred to.
      std::vector<AbaqusElement> elements(const Reference &reference)
      {
        text_.go_to(reference.place);
        return sets_.elements(reference.scope, reference.what);
      }

      dealii::CellData<3> &cell(const AbaqusElement &element)
      {
        // outside of the only instance its numbers count as well
        const bool is_of_only = element.scope == 0 && cells_.size() == 2 &&
                                cells_[0].count(element.number) == 0;
        const auto &cells = cells_[is_of_only ? 1 : element.scope];
        const auto found  = cells.find(element.number);
        if (found == cells.end())
          text_.refuse("there is no element " + std::to_string(element.number));
        return mesh_.mesh.cells[found->second];
      }

      TextScanner &text_;
      MeshBuilder mesh_;
      const AbaqusParts parts_;
      AbaqusSets sets_;
      // where they are in the mesh, by their numbers in each scope
      std::vector<std::unordered_map<std::int64_t, std::size_t>> cells_;
      // flat elements by scope and number, in the order of the file, and sets with such
      std::map<AbaqusElement, std::size_t> faces_;
      std::map<std::string, Reference> face_sets_;

      AbaqusScope scope_; // the present one
      AbaqusPlacement placement_;
      std::string part_; // to be read when it is known where the instance stands

      AbaqusKeyword keyword_;
      std::string unfinished_;

      std::set<std::string> passed_over_;
      std::vector<Surface> surfaces_;
      std::vector<std::pair<Reference, std::string>> sections_; // with the material
      std::map<std::string, Reference> element_sets_;           // those of *ELEMENT
    };
  } // namespace

  MeshData read_abaqus(TextScanner &text) { return AbaqusReader(text).read(); }
} // namespace stiction
