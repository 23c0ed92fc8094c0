#include <stiction/base/text/utf8.h>

namespace stiction
{
  std::size_t first_byte_not_utf8(const std::string &text)
  {
    std::size_t i = 0;
    while (i < text.size())
      {
        const auto first = static_cast<unsigned char>(text[i]);
        std::size_t n    = 0; // bytes that follow
        if (first >= 0xC2 && first <= 0xDF)
          n = 1;
        else if (first >= 0xE0 && first <= 0xEF)
          n = 2;
        else if (first >= 0xF0 && first <= 0xF4)
          n = 3;
        else if (first >= 0x80)
          return i;
        for (std::size_t k = 1; k <= n; ++k)
          {
            if (i + k >= text.size())
              return i;
            const auto byte = static_cast<unsigned char>(text[i + k]);
            // neither longer than needed, nor surrogates, nor above U+10FFFF
            const unsigned char low  = k > 1           ? 0x80
                                       : first == 0xE0 ? 0xA0
                                       : first == 0xF0 ? 0x90
                                                       : 0x80;
            const unsigned char high = k > 1           ? 0xBF
                                       : first == 0xED ? 0x9F
                                       : first == 0xF4 ? 0x8F
                                                       : 0xBF;
            if (byte < low || byte > high)
              return i;
          }
        i += n + 1;
      }
    return std::string::npos;
  }
} // namespace stiction
