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
#include <tuple>
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
        , elements_(1)
      {
      }

      MeshData read()
      {
        read_until("");
        end_of_data();
        const TextScanner::Place end = text_.here();
        if (mesh_.is_of_cells())
          {
            // plane elements so far, which count in sets alone
            const auto of_file = std::exchange(mesh_.mesh.faces.boundary_quads, {});
            add_surfaces();
            add_face_sets(of_file);
            name_materials();
          }
        text_.go_to(end);
        misspelt_.erase("");
        mesh_.mesh.damages.assign(misspelt_.begin(), misspelt_.end());
        if (!passed_over_.empty())
          mesh_.mesh.left_out.push_back(
            listed({passed_over_.begin(), passed_over_.end()}) +
            "; materials, loads and contact stand in the parameter file");
        return mesh_.finish();
      }

    private:
      struct Element
      {
        bool is_cell;      // or a plane one
        std::size_t place; // among the cells or the faces of the mesh
      };

      struct Surface
      {
        std::string name;
        AbaqusScope scope;
        TextScanner::Place place;
        // with the face of each
        std::vector<std::pair<AbaqusReference, unsigned int>> parts;
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
        const std::string elset = keyword_.value("ELSET");
        const bool has_members  = name == "*ELSET" || name == "*ELEMENT";
        set_ = has_members && !elset.empty() ? &sets_.at(refer_to(elset)) : nullptr;
        if (const std::string more = keyword_.of_the_problem(); !more.empty())
          passed_over_.insert(more);
        const bool is_combined = keyword_.has("COMBINE");
        if (name == "*SURFACE" && !is_combined && (type.empty() || type == "ELEMENT"))
          surfaces_.push_back({keyword_.value("NAME"), scope_, text_.here(), {}});
        else if (name == "*SURFACE")
          {
            passed_over_.insert(is_combined ? "combined surfaces" : "surfaces of nodes");
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
          sections_.emplace_back(refer_to(elset), keyword_.value("MATERIAL"));
        else if (name == "*ELSET" && elset.empty())
          text_.refuse("a set without a name, must be '*ELSET, ELSET=name'");
        else
          {
            keyword_.require_all_is_here(text_);
            misspelt_.insert(keyword_.misspelt(text_));
          }
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
        elements_.resize(std::max(elements_.size(), scope.number + 1));
        mesh_.mesh.body_names.resize(parts_.are_several() ? elements_.size() : 0);
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
          sets_.add_line(*set_, keyword_, items, scope_);
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
        const std::string type    = upper(keyword_.value("TYPE"));
        auto [gmsh_type, n_nodes] = abaqus::type_of_cell(type);
        const bool is_cell        = n_nodes > 0;
        if (!is_cell)
          std::tie(gmsh_type, n_nodes) = abaqus::type_of_face(type);
        if (n_nodes > 0)
          {
            const MeshBuilder::Nodes nodes =
              abaqus::nodes_of(items, n_nodes, type, text_);
            const std::int64_t number = text_.to_integer(items[0]);
            const std::size_t place =
              is_cell ? mesh_.mesh.cells.size() : mesh_.mesh.faces.boundary_quads.size();
            if (!elements_[scope_.number].emplace(number, Element{is_cell, place}).second)
              text_.refuse("element " + items[0] + " stands twice, must stand once");
            // nodes inside of a hexahedron: the centre, then faces S1 to S6
            mesh_.add_element(gmsh_type, 0,
                              in_gmsh_order(nodes, {{21, 23, 26, 24, 25, 22, 20}}));
            if (is_cell && parts_.are_several())
              mesh_.mesh.body_of_cell.push_back(scope_.number);
            if (set_ != nullptr)
              {
                set_->elements.push_back({scope_.number, number});
                set_->has_cells = set_->has_cells || is_cell;
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

      void add_surfaces()
      {
        for (const Surface &surface : surfaces_)
          {
            text_.go_to(surface.place);
            const std::string name = name_of(surface);
            if (ids_.count(upper(name)) > 0)
              text_.refuse("surface '" + name +
                           "' stands twice, must stand once: capital letters make no "
                           "difference in names");
            const unsigned int id = id_of_boundary(name);
            for (const auto &part : surface.parts)
              for (const AbaqusElement &element : sets_.elements(part.first))
                {
                  const auto &of_cell = cell(element, part.first).vertices;
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
        for (const AbaqusSets::Set *const set : sets_.all())
          for (const AbaqusElement &element : sets_.elements(set->name))
            if (const Element *const face = find(element); is_plane(face))
              mesh_.add_face(id_of_boundary(name_of(set->name)),
                             of_file[face->place].vertices);
      }

      // Capital letters make no difference: its name is as it is written first.
      unsigned int id_of_boundary(const std::string &name)
      {
        const auto [id, is_new] = ids_.emplace(upper(name), ids_.size() + 1);
        if (is_new)
          mesh_.add_name(name, id->second, mesh_.mesh.boundary_names);
        return id->second;
      }

      std::string name_of(const AbaqusReference &set) const
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
          for (const AbaqusSets::Set *const set : sets_.all())
            if (set->has_cells)
              sections_.emplace_back(set->name, name_of(set->name));
        unsigned int last = 0;
        std::map<std::string, unsigned int> ids;
        for (const auto &section : sections_)
          {
            text_.go_to(section.first.place);
            const auto id = ids.emplace(upper(section.second), last + 1);
            if (id.second)
              mesh_.add_name(section.second, ++last, mesh_.mesh.material_names);
            for (const AbaqusElement &element : sets_.elements(section.first))
              {
                if (is_plane(find(element)))
                  continue;
                unsigned int &material = cell(element, section.first).material_id;
                if (material != 0 && material != id.first->second)
                  text_.refuse("element " + std::to_string(element.number) +
                               " has two materials, must have one");
                material = id.first->second;
              }
          }
      }

      // What stands on the line that was read last.
      AbaqusReference refer_to(const std::string &what)
      {
        return {what, scope_, text_.here()};
      }

      // Nothing if it is of no use here, or nowhere.
      const Element *find(const AbaqusElement &element) const
      {
        const auto found = elements_[element.scope].find(element.number);
        if (found != elements_[element.scope].end())
          return &found->second;
        // outside of the only instance its numbers count as well
        return element.scope == 0 && elements_.size() == 2 ? find({1, element.number})
                                                           : nullptr;
      }

      static bool is_plane(const Element *const element)
      {
        return element != nullptr && !element->is_cell;
      }

      dealii::CellData<3> &cell(const AbaqusElement &element,
                                const AbaqusReference &reference)
      {
        const Element *const found = find(element);
        if (found != nullptr && found->is_cell)
          return mesh_.mesh.cells[found->place];
        const std::string number = std::to_string(element.number);
        const std::string name =
          "element " + number +
          (reference.what == number ? "" : " of '" + reference.what + "'");
        text_.refuse(found == nullptr
                       ? "there is no " + name
                       : name + " is a plane element, must be a tetrahedron, prism or "
                                "hexahedron with faces S1, S2, ...; a set of plane "
                                "elements is a boundary without a '*SURFACE'");
      }

      TextScanner &text_;
      MeshBuilder mesh_;
      const AbaqusParts parts_;
      AbaqusSets sets_;
      std::vector<std::unordered_map<std::int64_t, Element>> elements_; // by scopes
      std::map<std::string, unsigned int> ids_; // of boundaries by names in capitals

      AbaqusScope scope_; // the present one
      AbaqusPlacement placement_;
      std::string part_; // to be read when it is known where the instance stands

      AbaqusKeyword keyword_;
      AbaqusSets::Set *set_ = nullptr; // that of the keyword, if it has one
      std::string unfinished_;

      std::set<std::string> passed_over_, misspelt_;
      std::vector<Surface> surfaces_;
      std::vector<std::pair<AbaqusReference, std::string>> sections_; // with the material
    };
  } // namespace

  MeshData read_abaqus(TextScanner &text) { return AbaqusReader(text).read(); }
} // namespace stiction
