// Keyboard: every shortcut is on exactly one key of every layout, the one labelled with it where there is one.
#include "catch.hpp"

#include "viewer/keyboard.hpp"

#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <vector>

using namespace drapeau;

namespace {

using Keys = std::vector<std::string>;

Keys keys(const std::string& text) {
    std::istringstream words(text);
    return {std::istream_iterator<std::string>(words), {}};
}

// What the keys type unshifted, from the upper left to the lower right, all in the order of the US keyboard.
const Keys us = keys(
    "` 1 2 3 4 5 6 7 8 9 0 - = "
    "q w e r t y u i o p [ ] \\ "
    "a s d f g h j k l ; ' "
    "z x c v b n m , . /");
const std::map<std::string, Keys> layouts{
    {"US", us},
    {"German", keys("^ 1 2 3 4 5 6 7 8 9 0 ß ´ "
                    "q w e r t z u i o p ü + # "
                    "a s d f g h j k l ö ä "
                    "y x c v b n m , . -")},
    {"AZERTY", keys("² & é \" ' ( - è _ ç à ) = "
                    "a z e r t y u i o p ^ $ * "
                    "q s d f g h j k l m ù "
                    "w x c v b n , ; : !")},
    {"bépo", keys("$ \" « » ( ) @ + - / * = % "
                  "b é p o è ^ v d l j z w ç "
                  "a u i e , c t s r n m "
                  "à y x . k ' q g h f")},
    {"Dvorak", keys("` 1 2 3 4 5 6 7 8 9 0 [ ] "
                    "' , . p y f g c r l / = \\ "
                    "a o e u i d h t n s - "
                    "; q j k x b m w v z")},
    {"Russian", keys("ё 1 2 3 4 5 6 7 8 9 0 - = "
                     "й ц у к е н г ш щ з х ъ \\ "
                     "ф ы в а п р о л д ж э "
                     "я ч с м и т ь б ю .")},
    {"Greek", keys("` 1 2 3 4 5 6 7 8 9 0 - = "
                   "; ς ε ρ τ υ θ ι ο π [ ] \\ "
                   "α σ δ φ γ η ξ κ λ ΄ ' "
                   "ζ χ ψ ω β ν μ , . /")},
    {"Hebrew", keys("; 1 2 3 4 5 6 7 8 9 0 - = "
                    "/ ' ק ר א ט ו ן ם פ ] [ \\ "
                    "ש ד ג כ ע י ח ל ך ף , "
                    "ז ס ב ה נ מ צ ת ץ .")},
};

char us_letter(std::size_t place) {
    const char c = us[place][0];
    return c >= 'a' && c <= 'z' ? c : '\0';
}

char letter_at(const Keys& layout, std::size_t place) {
    return shortcut_letter(layout[place], us_letter(place), layout);
}

}  // namespace

TEST_CASE("every shortcut letter is on exactly one key of every layout") {
    for (const auto& [name, layout] : layouts) {
        CAPTURE(name);
        REQUIRE(layout.size() == us.size());
        std::map<char, int> found;
        for (std::size_t place = 0; place < us.size(); ++place) ++found[letter_at(layout, place)];
        for (char letter = 'a'; letter <= 'z'; ++letter) {
            CAPTURE(letter);
            CHECK(found[letter] == 1);
        }
    }
}

TEST_CASE("a key labelled with a Latin letter is that letter and no other") {
    for (const auto& [name, layout] : layouts)
        for (std::size_t place = 0; place < us.size(); ++place) {
            const std::string& label = layout[place];
            CAPTURE(name, label);
            if (label.size() == 1 && label[0] >= 'a' && label[0] <= 'z') CHECK(letter_at(layout, place) == label[0]);
        }
}

TEST_CASE("a layout without Latin letters has them where a US keyboard does") {
    for (const std::string name : {"Russian", "Greek", "Hebrew"}) {
        CAPTURE(name);
        for (std::size_t place = 0; place < us.size(); ++place)
            CHECK(letter_at(layouts.at(name), place) == us_letter(place));
    }
}

TEST_CASE("a capital letter is its small one, and a key that types nothing is where it is") {
    CHECK(shortcut_letter("Q", 'a', us) == 'q');
    CHECK(shortcut_letter("", 'q', {}) == 'q');
    CHECK(shortcut_letter("", '\0', us) == '\0');
}
