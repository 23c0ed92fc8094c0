#include <stiction/base/errors.h>
#include <stiction/base/text/contact_pairs.h>
#include <stiction/base/text/did_you_mean.h>
#include <stiction/base/text/in_words.h>
#include <stiction/base/text/parameter_file.h>
#include <stiction/base/text/parameter_pattern.h>
#include <stiction/base/text/read_line.h>
#include <stiction/base/text/utf8.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace stiction
{
  namespace
  {
    using dealii::ParameterHandler;
    using Declarations = nlohmann::ordered_json; // keeps their order
    using dealii::Utilities::trim;

    // The declared sections and entries, with patterns and current values.
    Declarations declared(const ParameterHandler &prm)
    {
      std::ostringstream out;
      prm.print_parameters(out, ParameterHandler::JSON |
                                  ParameterHandler::KeepDeclarationOrder);
      return Declarations::parse(out.str());
    }

    std::vector<std::string> keys_of(const Declarations &node)
    {
      std::vector<std::string> keys;
      for (const auto &item : node.items())
        keys.push_back(item.key());
      return keys;
    }

    std::string unknown_section(const Declarations &all, const std::string &section)
    {
      std::vector<std::string> known = keys_of(all), allowed = known;
      for (const std::string named : {"Body ", "Contact pair "})
        {
          allowed.push_back(named + "NAME");
          if (section.size() > named.size() &&
              section.compare(0, named.size(), named) != 0)
            known.push_back(named + section.substr(named.size()));
        }
      return ": unknown section '" + section + "'" + did_you_mean(section, known) +
             ", allowed are " + in_quotes(allowed) + ".";
    }

    std::string unknown_entry(const Declarations &all, const std::string &section,
                              const std::string &name)
    {
      std::string hint = did_you_mean(name, keys_of(all[section]));
      for (const auto &other : all.items())
        if (other.value().contains(name))
          hint = " (it stands in the section '" + other.key() + "')";
      return ": unknown entry '" + name + "' in section '" + section + "'" + hint +
             ", allowed are " + in_quotes(keys_of(all[section])) + ".";
    }

    // The next line that is no comment, and those that go on from it; false at the
    // end of the file.
    bool next_statement(std::istream &in, const std::string &file, unsigned int &number,
                        std::string &where, std::string &line)
    {
      for (line.clear(); line.empty() && read_line(in, line);)
        {
          where = file + ", line " + std::to_string(++number);
          if (std::any_of(line.begin(), line.end(), [](const unsigned char c) {
                return std::iscntrl(c) != 0 && c != '\t';
              }))
            throw InputError(where + ": is no statement but has bytes that are "
                                     "no text, must be a text file in UTF-8.");
          line = trim(line.substr(0, line.find('#')));
          while (!line.empty() && line.back() == '\\')
            {
              std::string next;
              read_line(in, next);
              ++number;
              line.pop_back();
              line = trim(line + trim(next.substr(0, next.find('#'))));
            }
        }
      return !line.empty();
    }

    // Entries by their old names.
    const std::map<std::string, std::pair<std::string, std::string>> moved = {
      {"Boundary conditions/Time", {"Time", "End"}}};

    // Section and name of an entry, perhaps by its old name.
    std::pair<std::string, std::string> present(const std::string &section,
                                                const std::string &name)
    {
      const auto entry = moved.find(section + "/" + name);
      return entry == moved.end() ? std::make_pair(section, name) : entry->second;
    }

    // Where a default value stands.
    const std::string not_set = "default value", command_line = "--set '";
  } // namespace

  void ParameterFile::assign(const std::string &where, const std::string &old_section,
                             const std::string &old_name, const std::string &value,
                             ParameterHandler &prm)
  {
    const auto [section, name] = present(old_section, old_name);
    for (const std::string &text : {section, name, value})
      if (const std::size_t bad = first_byte_not_utf8(text); bad != std::string::npos)
        throw InputError(where + ": byte " + std::to_string(bad + 1) + " of '" + text +
                         "' is no UTF-8, must be text in UTF-8.");
    const Declarations &all = *declared_;
    if (section.empty() || !all.contains(section))
      throw InputError(where + unknown_section(all, section));
    if (!all[section].contains(name))
      throw InputError(where + unknown_entry(all, section, name));

    prm.enter_subsection(section);
    try
      {
        prm.set(name, value);
      }
    catch (const dealii::ExceptionBase &)
      {
        const std::string pattern = all[section][name]["pattern_description"];
        throw InputError(where + ": " + section + "/" + name + " = " + value +
                         ", must be " + in_words(pattern) +
                         did_you_mean(value, choices_of(pattern)) + ".");
      }
    prm.leave_subsection();
    if (value.find_first_of("#\n\r") != std::string::npos)
      throw InputError(where + ": " + section + "/" + name + " = " + value +
                       ", must have no '#' and no line break, which a "
                       "parameter file could not repeat.");
    places_[section + "/" + name] = {where, value};
  }

  std::vector<std::string> ParameterFile::sections(const std::string &file,
                                                   const std::string &word)
  {
    std::ifstream in(file);
    std::vector<std::string> all;
    for (std::string line; read_line(in, line);)
      {
        std::istringstream words(line.substr(0, line.find('#')));
        std::string keyword, first, rest;
        words >> keyword >> first;
        std::getline(words, rest);
        const std::string section = first + ' ' + trim(rest);
        if (keyword == "subsection" && first == word && !trim(rest).empty() &&
            std::find(all.begin(), all.end(), section) == all.end())
          all.push_back(section);
      }
    return all;
  }

  void ParameterFile::read(const std::string &file,
                           const std::vector<std::string> &settings,
                           ParameterHandler &prm)
  {
    std::ifstream in(file);
    if (!file.empty() && (!in || (in.peek(), in.bad())))
      throw InputError(file + ": cannot be read, a parameter file is needed "
                              "(stiction --print-parameters prints one).");

    file_     = file;
    declared_ = std::make_shared<const Declarations>(declared(prm));
    for (const auto &group : declared_->items())
      for (const auto &entry : group.value().items())
        places_[group.key() + "/" + entry.key()] = {
          not_set, entry.value()["value"].get<std::string>()};

    ContactPairs pairs;
    std::map<std::string, unsigned int> first_line;
    std::string section, where, line;
    unsigned int number = 0;
    while (next_statement(in, file, number, where, line))
      {
        std::istringstream words(line);
        std::string keyword, rest;
        std::getline(words >> keyword >> std::ws, rest);
        if (keyword == "subsection")
          {
            if (!section.empty())
              throw InputError(where + ": section '" + rest + "' begins inside '" +
                               section + "', an 'end' is missing before it.");
            if (ContactPairs::is_pair(rest))
              pairs.begin(where, rest);
            else if (!declared_->contains(rest))
              throw InputError(where + unknown_section(*declared_, rest));
            section = rest;
          }
        else if (keyword == "end" && rest.empty())
          {
            if (section.empty())
              throw InputError(where + ": 'end' without a subsection.");
            section.clear();
          }
        else if (keyword == "set" && rest.find('=') != std::string::npos)
          {
            if (section.empty())
              throw InputError(where + ": '" + line +
                               "' stands outside of a subsection, all entries "
                               "stand in one.");
            const std::size_t equals = rest.find('=');
            const std::string name   = trim(rest.substr(0, equals));
            const auto entry         = present(section, name);
            const auto first =
              first_line.emplace(entry.first + "/" + entry.second, number);
            if (!first.second)
              throw InputError(where + ": " + section + "/" + name + " stands in line " +
                               std::to_string(first.first->second) +
                               " already, must stand once.");
            give(where, section, name, trim(rest.substr(equals + 1)), pairs, prm);
          }
        else
          throw InputError(where + ": '" + line +
                           "' is no statement, allowed are 'subsection NAME', 'set ENTRY "
                           "= VALUE', 'end' and comments beginning with '#'.");
      }
    if (!section.empty())
      throw InputError(file + ": the file ends inside section '" + section +
                       "', an 'end' is missing.");

    for (const std::string &setting : settings)
      give(setting, pairs, prm);
    assign_lists(pairs, prm);
  }

  void ParameterFile::give(const std::string &setting, ContactPairs &pairs,
                           ParameterHandler &prm)
  {
    const std::string where  = command_line + setting + "'";
    const std::size_t equals = setting.find('=');
    const std::size_t slash  = setting.find('/');
    if (equals == std::string::npos || slash > equals)
      throw InputError(where + ": must read 'Section/Entry=value'.");
    give(where, trim(setting.substr(0, slash)),
         trim(setting.substr(slash + 1, equals - slash - 1)),
         trim(setting.substr(equals + 1)), pairs, prm);
  }

  void ParameterFile::give(const std::string &where, const std::string &section,
                           const std::string &name, const std::string &value,
                           ContactPairs &pairs, ParameterHandler &prm)
  {
    if (ContactPairs::is_pair(section))
      pairs.set(where, section, name, value);
    else
      assign(where, section, name, value, prm);
  }

  void ParameterFile::assign_lists(const ContactPairs &pairs, ParameterHandler &prm)
  {
    const auto value_of = [&](const std::string &entry) {
      return places_.at(entry).value;
    };
    for (const ContactPairs::List &list : pairs.lists(value_of))
      {
        const std::string entry = list.section + "/" + list.name;
        require(places_.at(entry).where == not_set, entry,
                "must stand in the sections 'Contact pair', or all that they say in "
                "lists");
        if (!list.where.empty())
          assign(list.where, list.section, list.name, trim(list.value), prm);
        for (const auto &[where, name, value] : list.of_pairs)
          of_pairs_[entry].push_back({where.empty() ? not_set : where, value, name});
      }
  }

  std::map<std::string, std::string> ParameterFile::given(const bool or_default) const
  {
    std::map<std::string, std::string> values;
    for (const auto &[entry, place] : places_)
      if (or_default || place.where != not_set)
        values[entry] = place.value;
    return values;
  }

  ParameterFile ParameterFile::of_pair(const std::size_t number) const
  {
    ParameterFile file = *this;
    for (const auto &[entry, places] : of_pairs_)
      file.places_[entry] = places.at(number);
    return file;
  }

  std::string ParameterFile::section_of_pair(const std::string &entry,
                                             const std::size_t number) const
  {
    const auto pairs = of_pairs_.find(entry);
    const std::string &name =
      pairs == of_pairs_.end() ? entry : pairs->second.at(number).name;
    return name.substr(0, name.rfind('/'));
  }

  std::string ParameterFile::locate(const std::string &entry) const
  {
    const Place &place = places_.at(entry);
    return (place.where == not_set && !file_.empty() ? file_ + ", " : "") + place.where +
           ": " + (place.name.empty() ? entry : place.name);
  }

  std::string ParameterFile::describe(const std::string &entry) const
  {
    return locate(entry) + " = " + places_.at(entry).value;
  }

  std::string ParameterFile::describe_missing(const std::string &entry) const
  {
    return places_.at(entry).where == not_set ? file_ + ": " + entry + " is not set"
                                              : locate(entry) + " is empty";
  }

  void ParameterFile::refuse(const std::string &entry, const std::string &allowed) const
  {
    throw InputError(describe(entry) + ", " + allowed + ".");
  }

  void ParameterFile::require(const bool condition, const std::string &entry,
                              const std::string &allowed) const
  {
    if (!condition)
      refuse(entry, allowed);
  }

  std::string ParameterFile::find_file(const std::string &entry,
                                       const std::string &name) const
  {
    namespace fs         = std::filesystem;
    const fs::path given = name, beside = fs::path(file_).parent_path() / given;
    const bool is_typed = places_.at(entry).where.rfind(command_line, 0) == 0;
    std::error_code none;
    for (const fs::path &path : {is_typed ? given : beside, is_typed ? beside : given})
      {
        require(!fs::is_directory(path, none), entry, "is a directory, must be a file");
        if (fs::exists(path, none))
          return path;
      }
    refuse(entry, "cannot be read, there is " +
                    (beside == name ? "no such file"
                                    : "neither '" + name + "' nor '" + beside.string() +
                                        "', beside the parameter file"));
  }
} // namespace stiction
