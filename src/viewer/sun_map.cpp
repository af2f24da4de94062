#include "sun_map.hpp"

#include "software_renderer.hpp"

#include <glm/common.hpp>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace drapeau {

const glm::vec3 to_sun = glm::normalize(glm::vec3(-0.50f, 0.62f, 0.60f));

SunView sun_view_of(const FieldBuffer<float>& position) {
    const glm::mat4 turned = glm::lookAt(glm::vec3(0.0f), -to_sun, glm::vec3(0.0f, 1.0f, 0.0f));
    glm::vec3 low(1e9f), high(-1e9f);
    for (int row = 0; row < position.rows(); ++row)
        for (int column = 0; column < position.columns(); ++column) {
            const glm::vec3 seen(turned * glm::vec4(glm::vec3(position.at(column, row)), 1.0f));
            low = glm::min(low, seen);
            high = glm::max(high, seen);
        }
    if (low.x > high.x) return {};
    const glm::vec3 middle = 0.5f * (low + high), extent = high - low;
    const float around = 0.53f * std::max({extent.x, extent.y, extent.z, 1e-3f});
    return {.to_map = glm::ortho(middle.x - around, middle.x + around, middle.y - around, middle.y + around,
                                 -middle.z - around, -middle.z + around) *
                      turned,
            .side = 2.0f * around};
}

SunMap::SunMap() : depth_(make_texture()), target_(make_framebuffer()), side_(drawn_by_llvmpipe() ? 768 : 2048) {
    glActiveTexture(GL_TEXTURE7);
    glBindTexture(GL_TEXTURE_2D, depth_.id());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, side_, side_, 0, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    const GLfloat lit[] = {1.0f, 1.0f, 1.0f, 1.0f};
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, lit);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, target_.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_.id(), 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void SunMap::begin() const {
    glActiveTexture(GL_TEXTURE7);
    glBindTexture(GL_TEXTURE_2D, 0);  // never read where it is written
    glBindFramebuffer(GL_FRAMEBUFFER, target_.id());
    glViewport(0, 0, side_, side_);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glDepthMask(GL_TRUE);
    glClearDepth(1.0);
    glClear(GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_CLAMP);  // what is nearer to the sun than the cloth
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1.0f, 1.0f);
}

void SunMap::end() const {
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDisable(GL_DEPTH_CLAMP);
    glDisable(GL_DEPTH_TEST);
    glActiveTexture(GL_TEXTURE7);
    glBindTexture(GL_TEXTURE_2D, depth_.id());
}

}  // namespace drapeau
