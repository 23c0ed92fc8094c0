#include <stiction/base/errors.h>
#include <stiction/base/text/boundary_functions.h>
#include <stiction/base/text/contact_pairs.h>
#include <stiction/base/text/did_you_mean.h>
#include <stiction/base/text/in_words.h>

#include <algorithm>

namespace stiction
{
  namespace
  {
    struct Entry
    {
      std::string in_pair, section, in_section;
    };

    const std::vector<Entry> entries = {
      {"Boundary", "Boundary conditions", "Contact boundary"},
      {"Obstacle", "Boundary conditions", "Obstacle"},
      {"Slave side", "Boundary conditions", "Slave side"},
      {"Mesh gap", "Boundary conditions", "Mesh gap"},
      {"Sliding", "Boundary conditions", "Sliding"},
      {"Initial gap", "Boundary conditions", "Initial gap"},
      {"Displacement", "Boundary conditions", "Obstacle displacement"},
      {"Rotation", "Boundary conditions", "Obstacle rotation"},
      {"Force", "Boundary conditions", "Obstacle force"},
      {"Law", "Friction", "Law"},
      {"Coefficient", "Friction", "Coefficient"},
      {"Slip stress", "Friction", "Slip stress"},
      {"First direction", "Friction", "First direction"}};

    const std::string keyword = "Contact pair";

    std::vector<std::string> entry_names()
    {
      std::vector<std::string> names;
      for (const Entry &entry : entries)
        names.push_back(entry.in_pair);
      return names;
    }
  } // namespace

  bool ContactPairs::is_pair(const std::string &section)
  {
    return section == keyword || !name_of(section).empty();
  }

  std::string ContactPairs::name_of(const std::string &section)
  {
    const std::string begin = keyword + ' ';
    return section.rfind(begin, 0) == 0 ? section.substr(begin.size()) : "";
  }

  void ContactPairs::begin(const std::string &where, const std::string &pair)
  {
    for (const Pair &other : pairs_)
      if (other.name == pair)
        throw InputError(where + ": section '" + pair + "' stands in " + other.where +
                         " already, each contact pair must have a name of its own.");
    pairs_.push_back({where, pair, {}});
  }

  void ContactPairs::set(const std::string &where, const std::string &pair,
                         const std::string &entry, const std::string &value)
  {
    const auto found = std::find_if(pairs_.begin(), pairs_.end(), [&](const Pair &other) {
      return other.name == pair;
    });
    if (found == pairs_.end())
      {
        std::vector<std::string> known;
        for (const Pair &other : pairs_)
          known.push_back(other.name);
        throw InputError(where + ": there is no section '" + pair + "'" +
                         did_you_mean(pair, known) +
                         ", must be one of the parameter file" +
                         (known.empty() ? "." : ", " + in_quotes(known) + "."));
      }
    const std::vector<std::string> names = entry_names();
    if (std::count(names.begin(), names.end(), entry) == 0)
      throw InputError(where + ": unknown entry '" + entry + "' in section '" + pair +
                       "'" + did_you_mean(entry, names) + ", allowed are " +
                       in_quotes(names) + ".");
    if (split_at_bars(value).size() > 1)
      throw InputError(where + ": " + pair + "/" + entry + " = " + value +
                       ", must be one value without '|', since a pair has one contact "
                       "boundary.");
    found->entries[entry] = {where, value};
  }

  std::vector<ContactPairs::List> ContactPairs::lists(
    const std::function<std::string(const std::string &entry)> &default_of) const
  {
    for (const Pair &pair : pairs_)
      if (pair.entries.count("Boundary") == 0)
        throw InputError(pair.where + ": section '" + pair.name +
                         "' has no 'Boundary', write into it the one that may touch the "
                         "obstacle, such as 'set Boundary = bottom'.");

    if (pairs_.empty())
      return {};
    std::vector<List> lists;
    for (const Entry &entry : entries)
      {
        List list{"", entry.section, entry.in_section, "", {}};
        for (const Pair &pair : pairs_)
          {
            const auto said  = pair.entries.find(entry.in_pair);
            const bool is_so = said != pair.entries.end();
            list.of_pairs.push_back(
              {is_so ? said->second.where : "", pair.name + "/" + entry.in_pair,
               is_so ? said->second.value
                     : default_of(entry.section + "/" + entry.in_section)});
            const OfPair &last = list.of_pairs.back();
            if (is_so)
              list.where += (list.where.empty() ? "" : " and ") + last.where;
            list.value += (&pair == &pairs_.front() ? "" : " | ") + last.value;
          }
        lists.push_back(list);
      }
    return lists;
  }
} // namespace stiction
