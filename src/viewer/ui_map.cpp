#include "ui_map.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>

namespace drapeau {

namespace {

void append_field(std::string& text, std::string_view field) {
    for (const char c : field) text += (c == '\t' || c == '\n' || c == '\r') ? ' ' : c;
}

}  // namespace

UiMap::UiMap() {
    if (const char* file = std::getenv("DRAPEAU_UI_MAP")) file_ = file;
}

void UiMap::state(std::string_view name, std::string_view value) {
    if (!wanted()) return;
    text_ += "state\t";
    append_field(text_, name);
    text_ += '\t';
    append_field(text_, value);
    text_ += '\n';
}

void UiMap::state(std::string_view name, double value) {
    state(name, fmt::format("{:.9g}", value));
}

void UiMap::control(std::string_view label, float x0, float y0, float x1, float y1, std::string_view value) {
    if (!wanted()) return;
    append_field(text_, label);
    text_ += fmt::format("\t{:.1f}\t{:.1f}\t{:.1f}\t{:.1f}\t", x0, y0, x1, y1);
    append_field(text_, value);
    text_ += '\n';
}

void UiMap::write() {
    if (!wanted()) return;
    const std::string aside = file_ + ".new";
    std::ofstream out(aside, std::ios::binary | std::ios::trunc);
    out << text_;
    out.close();
    if (out) std::rename(aside.c_str(), file_.c_str());
    text_.clear();
}

}  // namespace drapeau
