#include <stiction/base/text/read_line.h>

namespace stiction
{
  bool read_line(std::istream &in, std::string &line)
  {
    using Traits = std::istream::traits_type;
    line.clear();
    if (in.peek() == Traits::eof()) // at the end, or no file that can be read
      {
        in.setstate(std::ios::failbit);
        return false;
      }
    std::streambuf &text = *in.rdbuf();
    Traits::int_type c   = text.sbumpc();
    for (; c != Traits::eof() && c != '\n' && c != '\r'; c = text.sbumpc())
      line += Traits::to_char_type(c);
    if (c == Traits::eof())
      in.setstate(std::ios::eofbit);
    else if (c == '\r' && text.sgetc() == '\n')
      text.sbumpc();
    if (line.compare(0, byte_order_mark.size(), byte_order_mark) == 0)
      line.erase(0, byte_order_mark.size());
    return true;
  }
} // namespace stiction
