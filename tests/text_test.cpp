// Laws of text in messages: one line that is seen as it is, whatever the names in it hold.
#include "catch.hpp"

#include "io/text.hpp"

#include <algorithm>
#include <string>

using namespace drapeau;
using namespace std::string_literals;

TEST_CASE("every byte there is becomes visible text, and plain text stays as it is") {
    for (int byte = 0; byte < 256; ++byte) {
        const std::string seen = printable(std::string(1, static_cast<char>(byte)));
        INFO("byte " << byte << " is shown as " << seen);
        CHECK(std::all_of(seen.begin(), seen.end(), [](char c) { return c >= ' ' && c <= '~'; }));
        CHECK((seen.size() == 1) == (byte >= ' ' && byte <= '~'));
    }
    for (const std::string text : {"drapeau français", "旗 → 🏁", "a\\b", ""}) CHECK(printable(text) == text);
}

TEST_CASE("what would move the cursor is shown as an escape that names it") {
    CHECK(printable("a\nb\tc\rd") == "a\\nb\\tc\\rd");
    CHECK(printable("\x1b[2J\x7f\0"s) == "\\x1b[2J\\x7f\\x00");
    CHECK(printable("\xC2\x9B 2J") == "\\u009b 2J");                     // the one-character form of ESC [
    CHECK(printable("\xE2\x80\xA8 \xE2\x80\xAE") == "\\u2028 \\u202e");  // a line separator, text turned around
    CHECK(printable("fran\xE7"
                    "ais \xF0\x9F\x8F") == "fran\\xe7ais \\xf0\\x9f\\x8f");
}

TEST_CASE("what was made printable is printable already") {
    for (const std::string text : {"a\nb", "\xC2\x9B", "\xFF", "\\x1b"})
        CHECK(printable(printable(text)) == printable(text));
}

TEST_CASE("a quantity has the unit that suits it, and no exponent") {
    CHECK(quantity(0.11, "m/s", 2) == "110 mm/s");
    CHECK(quantity(84.12e-9, "s") == "84.1 ns");
    CHECK(quantity(0.99999, "s") == "1 s");
    CHECK(quantity(0.0, "J") == "0 J");
}

TEST_CASE("one thing is singular, none and several are plural") {
    CHECK(counted(0, "point") == "0 points");
    CHECK(counted(1, "point") == "1 point");
    CHECK(counted(21, "point") == "21 points");
}

TEST_CASE("a long text is cut between characters, and says so") {
    CHECK(one_line("abc", 3) == "abc");
    CHECK(one_line("abcd", 3) == "abc...");
    for (std::size_t longest = 0; longest < 12; ++longest) {
        const std::string cut = one_line("é→🏁é→🏁", longest);
        INFO(longest << ": " << cut);
        CHECK(is_utf8(cut));
        CHECK(cut == printable(cut));
        CHECK(cut.size() <= longest + 3);
    }
    CHECK(one_line("a\nb") == "a\\nb");
}
