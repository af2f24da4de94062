// Shader: a program made of two files of shaders/, found from the program's own place, never the working directory.
#pragma once

#include "gl_objects.hpp"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <filesystem>
#include <span>
#include <string>

namespace drapeau {

/// shaders/ of the source tree (seen from any build folder below it) or share/drapeau/shaders of the installation.
/// Throws InputError if there is none.
std::filesystem::path shaders_directory();

class Shader {
public:
    /// Compiles NAME.vert with NAME.frag, or the two named. A line `#include "file"` stands for that file.
    explicit Shader(const std::string& name) : Shader(name, name) {}
    Shader(const std::string& vertex, const std::string& fragment);

    void use() const { glUseProgram(program_.id()); }
    void set(const char* name, int value) const;
    void set(const char* name, float value) const;
    void set(const char* name, glm::ivec2 value) const;
    void set(const char* name, glm::vec2 value) const;
    void set(const char* name, glm::vec3 value) const;
    void set(const char* name, std::span<const glm::vec3> values) const;

private:
    GlProgram program_;
};

}  // namespace drapeau
