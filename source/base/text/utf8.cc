#include <stiction/base/text/utf8.h>

#include <boost/locale/utf.hpp>

namespace stiction
{
  std::size_t first_byte_not_utf8(const std::string &text)
  {
    using namespace boost::locale::utf;
    for (auto c = text.begin(); c != text.end();)
      {
        const auto first = c;
        if (!is_valid_codepoint(utf_traits<char>::decode(c, text.end())))
          return first - text.begin();
      }
    return std::string::npos;
  }
} // namespace stiction
