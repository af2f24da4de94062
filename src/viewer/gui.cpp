#include "gui.hpp"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <filesystem>
#include <system_error>

namespace drapeau {

namespace {

constexpr float font_height = 15.0f;  // window units
constexpr float large_font = 24.0f;   // pixels; from here on glyphs are sharp without oversampling

// What names of files and scenes may hold, of whatever the font has of it. ImGui sets letters one by one from left to
// right: Arabic and Hebrew can be told apart rather than read.
constexpr ImWchar glyph_ranges[] = {
    0x0020, 0x07ff,  // Latin, Greek, Cyrillic, Armenian, Hebrew, Arabic
    0x0e00, 0x0eff,  // Thai, Lao
    0x10a0, 0x10ff,  // Georgian
    0x1d00, 0x1fff,  // phonetic letters, Latin and Greek with accents
    0x2000, 0x27bf,  // punctuation, currencies, arrows, mathematics, shapes, symbols
    0x2c60, 0x2dff,  // more Latin and Cyrillic
    0xa640, 0xa7ff,  // more Cyrillic and Latin
    0xfb00, 0xfb4f,  // ligatures
    0xfffd, 0xfffd,  // what stands for any other character
    0,
};

// DejaVu Sans or what else is usually there; without any, ImGui's own small font.
void load_font(float scale, float pixels_per_unit) {
    ImGuiIO& io = ImGui::GetIO();
    for (const char* file :
         {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
          "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf", "/usr/share/fonts/TTF/DejaVuSans.ttf"}) {
        std::error_code failure;
        if (!std::filesystem::is_regular_file(file, failure)) continue;
        ImFontConfig config;
        const float height = font_height * scale * pixels_per_unit;
        config.OversampleH = height < large_font ? 2 : 1;
        config.OversampleV = 1;
        if (!io.Fonts->AddFontFromFileTTF(file, height, &config, glyph_ranges)) continue;
        io.FontGlobalScale = 1.0f / pixels_per_unit;
        return;
    }
    io.Fonts->AddFontDefault();
    io.FontGlobalScale = scale;
}

ImVec4 shade(unsigned rgb, float alpha = 1.0f) {
    return {float(rgb >> 16 & 255u) / 255.0f, float(rgb >> 8 & 255u) / 255.0f, float(rgb & 255u) / 255.0f, alpha};
}

void set_style(float scale) {
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowRounding = 8.0f;
    style.FrameRounding = 4.0f;
    style.GrabRounding = 4.0f;
    style.PopupRounding = 5.0f;
    style.ScrollbarRounding = 6.0f;
    style.ScrollbarSize = 11.0f;
    style.GrabMinSize = 9.0f;
    style.WindowBorderSize = 1.0f;  // boxes may lie over the panel
    style.PopupBorderSize = 1.0f;
    style.WindowPadding = {14.0f, 12.0f};
    style.FramePadding = {7.0f, 3.0f};
    style.ItemSpacing = {7.0f, 5.0f};
    style.ItemInnerSpacing = {6.0f, 4.0f};
    ImVec4* colors = style.Colors;
    colors[ImGuiCol_Text] = shade(0xe8ecf1);
    colors[ImGuiCol_TextDisabled] = shade(0x93a0b0);
    colors[ImGuiCol_WindowBg] = shade(0x19212c);
    colors[ImGuiCol_PopupBg] = shade(0x1b2430, 0.98f);
    colors[ImGuiCol_Border] = shade(0x3a4757);
    colors[ImGuiCol_FrameBg] = shade(0x2a3543);
    colors[ImGuiCol_FrameBgHovered] = shade(0x354354);
    colors[ImGuiCol_FrameBgActive] = shade(0x3d4d61);
    colors[ImGuiCol_Button] = shade(0x314052);
    colors[ImGuiCol_ButtonHovered] = shade(0x3f5269);
    colors[ImGuiCol_ButtonActive] = shade(0x4a6280);
    colors[ImGuiCol_SliderGrab] = shade(0x6ea8e0);
    colors[ImGuiCol_SliderGrabActive] = shade(0x8fc1f2);
    colors[ImGuiCol_CheckMark] = shade(0x8fc1f2);
    colors[ImGuiCol_Header] = shade(0x34506e);
    colors[ImGuiCol_HeaderHovered] = shade(0x3f6187);
    colors[ImGuiCol_HeaderActive] = shade(0x4a729e);
    colors[ImGuiCol_Separator] = shade(0x36424f);
    colors[ImGuiCol_ScrollbarBg] = shade(0x161d27, 0.0f);
    colors[ImGuiCol_PlotHistogram] = shade(0x5fb98a);
    colors[ImGuiCol_TextSelectedBg] = shade(0x3f6187);
    style.ScaleAllSizes(scale);
}

/// The wheel stays with the window it turned as long as it turns on: not with one that is gone.
void free_wheel() {
    ImGuiWindow*& turned = ImGui::GetCurrentContext()->WheelingWindow;
    if (turned && !turned->Active) turned = nullptr;
}

}  // namespace

Gui::Gui(GLFWwindow* window, float scale, float pixels_per_unit) : window_(window) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    set_style(scale);
    load_font(scale, pixels_per_unit);
    ImGui_ImplGlfw_InitForOpenGL(window, true);
    ImGui_ImplOpenGL3_Init("#version 330 core");
}

Gui::~Gui() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

bool Gui::is_text_edited() const {
    const ImGuiContext& context = *ImGui::GetCurrentContext();
    return context.ActiveId != 0 && context.ActiveId == context.InputTextState.ID;
}

void Gui::begin(const GuiFrame& frame, const std::vector<InputEvent>& events, bool keeps_keys) {
    // A mouse that was there before the window came never enters it, and ImGui would not believe in it.
    const bool over = glfwGetWindowAttrib(window_, GLFW_HOVERED) != 0;
    if (over && !entered_) ImGui_ImplGlfw_CursorEnterCallback(window_, GLFW_TRUE);
    entered_ = over;
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {frame.size.x, frame.size.y};
    io.DisplayFramebufferScale = {frame.pixels_per_unit, frame.pixels_per_unit};
    if (frame.seconds > 0.0f) io.DeltaTime = frame.seconds;
    free_wheel();
    keys_.new_frame(events, keeps_keys);
}

bool Gui::close_list() {
    if (ImGui::GetCurrentContext()->OpenPopupStack.empty()) return false;
    ImGui::ClosePopupToLevel(0, true);
    return true;
}

void Gui::end() {
    ImGui::Render();
}

void Gui::draw() {
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace drapeau
