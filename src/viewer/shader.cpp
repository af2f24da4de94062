#include "shader.hpp"

#include "software_renderer.hpp"

#include "io/error.hpp"

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <vector>

namespace drapeau {

namespace fs = std::filesystem;

fs::path shaders_directory() {
    std::error_code failure;
    const fs::path program = fs::read_symlink("/proc/self/exe", failure);
    for (fs::path folder = program.parent_path(); !folder.empty(); folder = folder.parent_path()) {
        for (const char* place : {"shaders", "share/drapeau/shaders"})
            if (fs::exists(folder / place / "cloth.vert", failure)) return folder / place;
        if (folder == folder.root_path()) break;
    }
    throw InputError("the folder shaders/ is missing: none above " + program.parent_path().string());
}

namespace {

std::string read_source(const fs::path& folder, const std::string& name) {
    std::ifstream in(folder / name);
    if (!in) throw InputError((folder / name).string() + ": cannot be read");
    std::string source, line;
    while (std::getline(in, line)) {
        const auto quote = line.find('"');
        if (line.starts_with("#include") && quote != std::string::npos)
            source += read_source(folder, line.substr(quote + 1, line.rfind('"') - quote - 1));
        else
            source += line + "\n";
    }
    return source;
}

GlShader compile(GLenum kind, const fs::path& folder, const std::string& name) {
    std::string source = read_source(folder, name);
    const std::string processor = drawn_by_llvmpipe() ? "1" : "0";
    source.insert(source.find('\n') + 1, "#define DRAWN_BY_PROCESSOR " + processor + "\n");  // below its version
    const char* text = source.c_str();
    GlShader shader(glCreateShader(kind));
    glShaderSource(shader.id(), 1, &text, nullptr);
    glCompileShader(shader.id());
    GLint good = 0;
    glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &good);
    if (good) return shader;
    std::vector<char> log(4096);
    glGetShaderInfoLog(shader.id(), GLsizei(log.size()), nullptr, log.data());
    throw std::runtime_error("shader " + name + " does not compile: " + log.data());
}

}  // namespace

Shader::Shader(const std::string& vertex, const std::string& fragment) : program_(glCreateProgram()) {
    const fs::path folder = shaders_directory();
    const GlShader vertex_part = compile(GL_VERTEX_SHADER, folder, vertex + ".vert");
    const GlShader fragment_part = compile(GL_FRAGMENT_SHADER, folder, fragment + ".frag");
    glAttachShader(program_.id(), vertex_part.id());
    glAttachShader(program_.id(), fragment_part.id());
    glLinkProgram(program_.id());
    GLint good = 0;
    glGetProgramiv(program_.id(), GL_LINK_STATUS, &good);
    if (!good) {
        std::vector<char> log(4096);
        glGetProgramInfoLog(program_.id(), GLsizei(log.size()), nullptr, log.data());
        throw std::runtime_error("shaders " + vertex + ", " + fragment + " do not link: " + log.data());
    }

    // The same names stand for the same places in every shader: the frame's constants, the position textures and so on.
    const GLuint block = glGetUniformBlockIndex(program_.id(), "Frame");
    if (block != GL_INVALID_INDEX) glUniformBlockBinding(program_.id(), block, 0);
    use();
    set("position_x", 0);
    set("position_y", 1);
    set("position_z", 2);
    set("picture", 3);
    set("surface_place", 5);
    set("surface_normal", 6);
    set("sun_map", 7);
    set("stretch_of_masses", 8);
}

void Shader::set(const char* name, int value) const {
    glUniform1i(glGetUniformLocation(program_.id(), name), value);
}
void Shader::set(const char* name, float value) const {
    glUniform1f(glGetUniformLocation(program_.id(), name), value);
}
void Shader::set(const char* name, glm::ivec2 value) const {
    glUniform2i(glGetUniformLocation(program_.id(), name), value.x, value.y);
}
void Shader::set(const char* name, glm::vec2 value) const {
    glUniform2f(glGetUniformLocation(program_.id(), name), value.x, value.y);
}
void Shader::set(const char* name, glm::vec3 value) const {
    glUniform3f(glGetUniformLocation(program_.id(), name), value.x, value.y, value.z);
}
void Shader::set(const char* name, std::span<const glm::vec3> values) const {
    glUniform3fv(glGetUniformLocation(program_.id(), name), GLsizei(values.size()), &values[0].x);
}

}  // namespace drapeau
