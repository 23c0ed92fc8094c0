#include "mesh_builder.h"

#include <set>

namespace stiction
{
  namespace
  {
    // Sections of the formats 2.2 and 4.1 (Gmsh's manual, "File formats").
    // deal.II's GridIn reads both, but in a Release build it believes counts
    // and dimensions, it drops names and takes no curve in two groups.
    class GmshReader
    {
    public:
      explicit GmshReader(TextScanner &text)
        : text_(text)
        , mesh_(text)
      {
      }

      MeshData read()
      {
        std::string line;
        while (text_.next_line(line))
          if (!line.empty())
            read_section(line);
        if (!has_format_)
          text_.refuse("is not a Gmsh file, which begins with '$MeshFormat'");
        return mesh_.finish();
      }

    private:
      void read_section(const std::string &name)
      {
        if (!has_format_ && name != "$MeshFormat")
          text_.refuse("is not a Gmsh file, which begins with '$MeshFormat'");
        if (name == "$Elements" && !has_nodes_)
          text_.refuse("section '$Elements' stands here and no section '$Nodes' before "
                       "it, nodes must stand before the elements that have them");
        if (name == "$MeshFormat")
          read_format();
        else if (name == "$PhysicalNames")
          read_physical_names();
        else if (name == "$Entities")
          read_entities();
        else if (name == "$Nodes")
          {
            is_4_ ? read_nodes_4() : read_nodes_2();
            has_nodes_ = true;
          }
        else if (name == "$Elements")
          is_4_ ? read_elements_4() : read_elements_2();
        else if (name[0] != '$')
          text_.refuse("'" + name.substr(0, 40) +
                       "' stands where a section should begin");

        // sections that are known are at their end now, others are passed over
        const bool has_counts =
          name == "$PhysicalNames" || name == "$Nodes" || name == "$Elements";
        const std::string end = "$End" + name.substr(1);
        std::string line      = text_.rest_of_line();
        while (line != end)
          {
            if (has_counts && line.find_first_not_of(" \t\r") != std::string::npos)
              text_.refuse("'" + line.substr(0, 40) + "' stands where section '" + name +
                           "' should end, its count must be that of its lines");
            if (!text_.next_line(line))
              text_.refuse("section '" + name + "' has no end");
          }
      }

      void read_format()
      {
        const std::string version = text_.word();
        if (version != "2.2" && version != "4.1")
          text_.refuse("is a Gmsh file of version " + version.substr(0, 40) +
                       ", must be of version 2.2 or 4.1, 'gmsh -format msh41' writes it");
        if (text_.word() != "0")
          text_.refuse("is a binary file, must be text, 'gmsh -bin 0' writes it");
        text_.rest_of_line();
        is_4_       = version == "4.1";
        has_format_ = true;
      }

      void read_physical_names()
      {
        for (std::uint64_t n = text_.count(); n > 0; --n)
          {
            const std::int64_t dimension = text_.integer();
            const std::int64_t number    = text_.integer();
            std::string name             = text_.rest_of_line();
            if (name.size() < 2 || name.front() != '"' || name.back() != '"')
              text_.refuse("a name in '\"' should stand here");
            name = name.substr(1, name.size() - 2);
            if (dimension < 2)
              continue;
            if (number == 0)
              text_.refuse("the physical group '" + name +
                           "' has the number 0, which is that of parts in no "
                           "group, must be a number > 0");
            mesh_.add_name(name, number,
                           dimension == 2 ? mesh_.mesh.boundary_names
                                          : mesh_.mesh.material_names);
          }
      }

      void read_entities()
      {
        std::array<std::uint64_t, 4> n;
        for (auto &count : n)
          count = text_.count();
        for (int dimension = 0; dimension < 4; ++dimension)
          for (std::uint64_t i = 0; i < n[dimension]; ++i)
            {
              const std::int64_t entity = text_.integer();
              // where it is: a point, or the corners of a box
              text_.skip(dimension == 0 ? 3 : 6);
              const std::uint64_t n_groups = text_.count();
              std::set<std::int64_t> groups;
              for (std::uint64_t g = 0; g < n_groups; ++g)
                groups.insert(std::abs(text_.integer()));
              if (dimension > 0)
                text_.skip(text_.count());
              if (dimension == 3 && groups.size() > 1)
                text_.refuse("volume " + std::to_string(entity) +
                             " is in two physical groups, must be in one at most");
              if (!groups.empty())
                groups_of_[dimension][entity] = groups;
            }
      }

      void read_nodes_2()
      {
        for (std::uint64_t n = text_.count(); n > 0; --n)
          {
            const std::int64_t number = text_.integer();
            mesh_.add_node(number, {text_.real(), text_.real(), text_.real()});
          }
      }

      void read_nodes_4()
      {
        std::uint64_t n_blocks = text_.count();
        text_.skip(3); // how many, smallest and largest number
        for (; n_blocks > 0; --n_blocks)
          {
            const std::uint64_t dimension = text_.count();
            text_.skip(1); // the entity
            const bool is_parametric = text_.count() != 0;
            for (const std::int64_t number : text_.integers(text_.count()))
              {
                mesh_.add_node(number, {text_.real(), text_.real(), text_.real()});
                text_.skip(is_parametric ? dimension : 0);
              }
          }
      }

      void read_elements_2()
      {
        for (std::uint64_t n = text_.count(); n > 0; --n)
          {
            text_.integer(); // its number
            const std::int64_t type    = text_.integer();
            const std::uint64_t n_tags = text_.count();
            const std::int64_t group   = n_tags == 0 ? 0 : text_.integer();
            text_.skip(n_tags == 0 ? 0 : n_tags - 1);
            read_element(type, {std::abs(group)});
          }
      }

      void read_elements_4()
      {
        std::uint64_t n_blocks = text_.count();
        text_.skip(3);
        for (; n_blocks > 0; --n_blocks)
          {
            const std::uint64_t dimension = text_.count();
            const std::int64_t entity     = text_.integer();
            const std::int64_t type       = text_.integer();
            const std::set<std::int64_t> &groups =
              groups_of_[dimension < 4 ? dimension : 0]
                .emplace(entity, std::set<std::int64_t>{0})
                .first->second;
            for (std::uint64_t n = text_.count(); n > 0; --n)
              {
                text_.integer();
                read_element(type, groups);
              }
          }
      }

      // Once for each group that it is in.
      void read_element(const std::int64_t type, const std::set<std::int64_t> &groups)
      {
        const std::size_t line     = text_.line_number();
        const unsigned int n_nodes = mesh_.element_kind(type).n_nodes;
        MeshBuilder::Nodes nodes;
        while (nodes.size() < n_nodes && text_.word()[0] != '$')
          nodes.push_back(text_.to_integer(text_.this_word()));
        // it may go on in the next line, but then ends with a line
        if (nodes.size() < n_nodes ||
            (text_.line_number() != line && !text_.rest_of_line().empty()))
          text_.refuse("the element that begins in line " + std::to_string(line) +
                       " has fewer than the " + std::to_string(n_nodes) +
                       " nodes of Gmsh's type " + std::to_string(type) +
                       ", must have as many before the next one begins");
        for (const std::int64_t group : groups)
          mesh_.add_element(type, group, nodes);
      }

      TextScanner &text_;
      MeshBuilder mesh_;
      std::array<std::map<std::int64_t, std::set<std::int64_t>>, 4> groups_of_;
      bool has_format_ = false, has_nodes_ = false, is_4_ = false;
    };
  } // namespace

  MeshData read_gmsh(TextScanner &text) { return GmshReader(text).read(); }
} // namespace stiction
