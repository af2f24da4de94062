// Laws of files that are not UTF-8: a message names what they are, so that they can be saved anew.
#include "catch.hpp"

#include "io/encoding.hpp"

#include <string>

using namespace drapeau;
using namespace std::string_literals;

namespace {

/// Western text as UTF-16, its high bytes first or last.
std::string utf16(const std::string& text, bool high_first) {
    std::string bytes;
    for (const char c : text) bytes += high_first ? "\0"s + c : c + "\0"s;
    return bytes;
}

}  // namespace

TEST_CASE("UTF-8 text has no fault, with or without a mark and other alphabets") {
    for (const std::string text : {"name = \"Drapeau\"\n", "\xEF\xBB\xBFname = 1\n", "# français 旗 🏁\r\n", "\t\f"})
        CHECK(encoding_fault(text).empty());
}

TEST_CASE("UTF-16 is known by its mark, or by its zeros") {
    for (const bool high_first : {false, true}) {
        const std::string bytes = utf16("name = \"Drapeau\"\n", high_first);
        CHECK(encoding_fault(bytes).starts_with("UTF-16, not UTF-8"));
        CHECK(encoding_fault((high_first ? "\xFE\xFF" : "\xFF\xFE") + bytes).starts_with("UTF-16, not UTF-8"));
    }
    CHECK(encoding_fault("\xFF\xFE\0\0n\0\0\0"s).starts_with("UTF-32"));
}

TEST_CASE("a text of one byte a character is told by line and byte") {
    CHECK(encoding_fault("a\nb\nfran\xE7"
                         "ais\n") == "not UTF-8, line 3: byte 0xE7, probably Latin-1; save it as UTF-8");
    CHECK(encoding_fault("\x93quoted\x94").starts_with("not UTF-8, line 1: byte 0x93, probably Windows-1252"));
    // UTF-8 before it does not mislead.
    CHECK(encoding_fault("# é\n# \xE9\n").starts_with("not UTF-8, line 2: byte 0xE9, probably Latin-1"));
}

TEST_CASE("what holds control characters is no text of any kind") {
    for (const std::string& bytes : {"\x89PNG\r\n\x1a\n\0\0\0\rIHDR"s,
                                     "\x7F"
                                     "ELF\2\1\1\0"s,
                                     "a\0b"s, "\xE7\1"s})
        CHECK(encoding_fault(bytes) == "not a text file");
}
