#include "abaqus_sets.h"

#include <cstdlib>
#include <set>

namespace stiction
{
  namespace
  {
    bool is_number(const std::string &word)
    {
      return !word.empty() && word.find_first_not_of("0123456789") == std::string::npos;
    }

    std::vector<std::int64_t> generated_numbers(const std::vector<std::string> &items,
                                                const TextScanner &text)
    {
      if (items.size() < 2)
        text.refuse("the first and the last element should stand here");
      const std::int64_t first = text.to_integer(items[0]);
      const std::int64_t last  = text.to_integer(items[1]);
      const std::int64_t step =
        items.size() > 2 && !items[2].empty() ? text.to_integer(items[2]) : 1;
      // no mesh has so many elements, nor larger numbers of them
      constexpr std::int64_t largest = 10000000000, most = 20000000;
      if (step < 1 || std::abs(first) > largest || std::abs(last) > largest ||
          (last - first) / step >= most)
        text.refuse("the elements from " + items[0] + " to " + items[1] +
                    " in steps of " + std::to_string(step) +
                    " are too many, or no set, must be at most 20000000");
      std::vector<std::int64_t> numbers;
      for (std::int64_t e = first; e <= last; e += step)
        numbers.push_back(e);
      return numbers;
    }
  } // namespace

  AbaqusScope AbaqusSets::add_scope(const std::string &instance)
  {
    if (instance.empty())
      text_.refuse("an instance without a name, must be '*INSTANCE, NAME=name, PART=of'");
    const auto [place, is_new] =
      scopes_.emplace(upper(instance), AbaqusScope{scopes_.size() + 1, instance + "."});
    if (!is_new)
      text_.refuse("instance '" + instance +
                   "' stands twice, must have a name of its own");
    return place->second;
  }

  AbaqusScope AbaqusSets::scope_of(const std::string &instance) const
  {
    const auto found = scopes_.find(upper(instance));
    if (found == scopes_.end())
      text_.refuse("there is no instance '" + instance + "' above");
    return found->second;
  }

  AbaqusSets::Set &AbaqusSets::at(const AbaqusReference &name)
  {
    const auto [set, is_new] =
      sets_.try_emplace(upper(name.scope.prefix + name.what), Set{name, {}, {}, false});
    if (is_new)
      in_order_.push_back(&set->second);
    return set->second;
  }

  void AbaqusSets::add_line(Set &set, const AbaqusKeyword &keyword,
                            const std::vector<std::string> &items,
                            const AbaqusScope &scope) const
  {
    const std::string instance = keyword.value("INSTANCE");
    const AbaqusScope of_line  = instance.empty() ? scope : scope_of(instance);
    if (keyword.has("GENERATE"))
      for (const std::int64_t number : generated_numbers(items, text_))
        set.elements.push_back({of_line.number, number});
    else
      for (const std::string &item : items)
        if (is_number(item) && find(of_line, item) == nullptr) // as most of them
          set.elements.push_back({of_line.number, text_.to_integer(item)});
        else if (!item.empty())
          set.others.push_back({item, of_line, text_.here()});
  }

  const AbaqusSets::Set *AbaqusSets::find(const AbaqusScope &scope,
                                          const std::string &set) const
  {
    const auto found = sets_.find(upper(scope.prefix + set));
    if (found != sets_.end())
      return &found->second;
    return scope.number == 0 && scopes_.size() == 1 ? find(scopes_.begin()->second, set)
                                                    : nullptr;
  }

  std::vector<AbaqusElement> AbaqusSets::elements(const AbaqusReference &reference) const
  {
    std::vector<AbaqusElement> all;
    std::vector<AbaqusReference> open = {reference};
    std::set<const Set *> seen; // each counts once, even in itself
    while (!open.empty())
      {
        const AbaqusReference next = open.back();
        open.pop_back();
        const Set *const set = find(next.scope, next.what);
        text_.go_to(next.place);
        if (set == nullptr)
          all.push_back(element(next));
        else if (seen.insert(set).second)
          {
            all.insert(all.end(), set->elements.begin(), set->elements.end());
            open.insert(open.end(), set->others.rbegin(), set->others.rend());
          }
      }
    text_.go_to(reference.place);
    return all;
  }

  AbaqusElement AbaqusSets::element(const AbaqusReference &reference) const
  {
    const auto &what  = reference.what;
    const auto &scope = reference.scope;
    if (is_number(what))
      return {scope.number, text_.to_integer(what)};
    const std::size_t dot = what.rfind('.');
    const auto instance   = scopes_.find(upper(what.substr(0, dot)));
    if (scope.number != 0 || dot == std::string::npos || instance == scopes_.end() ||
        !is_number(what.substr(dot + 1)))
      text_.refuse("there is no set of elements '" + what.substr(0, 40) + "'");
    return {instance->second.number, text_.to_integer(what.substr(dot + 1))};
  }
} // namespace stiction
