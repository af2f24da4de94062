// Cloth: what evolves. One array per component (x y z vx vy vz), rows padded to whole registers.
//
// Mass (column i, row j) is element j * stride + i. Padding stays at zero: it has no mass and no spring.
#pragma once

#include "drapeau/lanes.hpp"

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <new>

namespace drapeau {

/// The grid at rest: column i, row j at (i * pitch_x, -j * pitch_y, 0), in metres.
struct Grid {
    int columns = 2;
    int rows = 2;
    double pitch_x = 0.1;  // m, between columns
    double pitch_y = 0.1;  // m, between rows

    long long masses() const { return static_cast<long long>(columns) * rows; }
    glm::dvec3 rest(int i, int j) const { return {i * pitch_x, -j * pitch_y, 0.0}; }
    double pitch_diagonal() const { return std::hypot(pitch_x, pitch_y); }
};

/// The grid that spreads `columns` x `rows` masses over width x height (m); a chain ignores the size across.
inline Grid spread(int columns, int rows, double width, double height) {
    return {columns, rows, columns > 1 ? width / (columns - 1) : width, rows > 1 ? height / (rows - 1) : height};
}

/// `count` Reals, all zero, aligned for registers, with one register of readable zeros on either side.
template <class Real>
class Array {
public:
    Array() = default;
    explicit Array(std::size_t count, std::size_t shift_bytes = 0)
        : bytes_(static_cast<std::byte*>(
              ::operator new(count * sizeof(Real) + 2 * row_alignment + shift_bytes, std::align_val_t(row_alignment)))),
          first_(reinterpret_cast<Real*>(bytes_.get() + row_alignment + shift_bytes)),
          count_(count) {
        std::fill_n(bytes_.get(), count * sizeof(Real) + 2 * row_alignment + shift_bytes, std::byte{0});
    }

    Real* data() { return first_; }
    const Real* data() const { return first_; }
    std::size_t size() const { return count_; }
    Real& operator[](std::size_t n) { return first_[n]; }
    const Real& operator[](std::size_t n) const { return first_[n]; }
    Real* begin() { return first_; }
    Real* end() { return first_ + count_; }
    const Real* begin() const { return first_; }
    const Real* end() const { return first_ + count_; }

private:
    struct Free {
        void operator()(std::byte* bytes) const { ::operator delete(bytes, std::align_val_t(row_alignment)); }
    };
    std::unique_ptr<std::byte, Free> bytes_;
    Real* first_ = nullptr;
    std::size_t count_ = 0;
};

/// One row of a cloth: pointers to its first mass, component by component.
template <class Real>
struct Row {
    Real *x, *y, *z, *vx, *vy, *vz;

    template <class V>
    DRAPEAU_INLINE Triple<V> position(int i) const {
        return {Lanes<V>::load(x + i), Lanes<V>::load(y + i), Lanes<V>::load(z + i)};
    }
    template <class V>
    DRAPEAU_INLINE Triple<V> velocity(int i) const {
        return {Lanes<V>::load(vx + i), Lanes<V>::load(vy + i), Lanes<V>::load(vz + i)};
    }
    template <class V>
    DRAPEAU_INLINE void set_position(int i, const Triple<V>& p) const {
        Lanes<V>::store(x + i, p.x), Lanes<V>::store(y + i, p.y), Lanes<V>::store(z + i, p.z);
    }
    template <class V>
    DRAPEAU_INLINE void set_velocity(int i, const Triple<V>& v) const {
        Lanes<V>::store(vx + i, v.x), Lanes<V>::store(vy + i, v.y), Lanes<V>::store(vz + i, v.z);
    }
};

/// The rows of a cloth, without owning them: what kernels are given.
template <class Real>
struct Rows {
    Row<Real> first;
    std::ptrdiff_t stride;
    int rows;

    DRAPEAU_INLINE Row<Real> operator[](std::ptrdiff_t j) const {
        const std::ptrdiff_t n = j * stride;
        return {first.x + n, first.y + n, first.z + n, first.vx + n, first.vy + n, first.vz + n};
    }
};

/// The widest register's number of Reals.
template <class Real>
inline constexpr int widest = static_cast<int>(row_alignment / sizeof(Real));

/// Columns rounded up to a whole number of the widest registers: what a loop over a row covers.
template <class Real>
constexpr int padded(int columns) {
    return (columns + widest<Real> - 1) / widest<Real> * widest<Real>;
}

template <class Real>
class Cloth {
public:
    explicit Cloth(const Grid& grid) : grid_(grid), stride_(padded<Real>(grid.columns) + widest<Real>) {
        for (int c = 0; c < 6; ++c) component_[c] = Array<Real>(count(), c * component_shift_bytes);
    }

    const Grid& grid() const { return grid_; }
    /// Elements a loop over a row covers, and elements from one row to the next: a register more, always zero, so that
    /// looking one column past the end never meets another row.
    int width() const { return stride_ - widest<Real>; }
    int stride() const { return stride_; }
    std::size_t count() const { return static_cast<std::size_t>(stride_) * grid_.rows; }

    /// x y z vx vy vz, rows * stride elements each.
    Array<Real>& component(int c) { return component_[c]; }
    const Array<Real>& component(int c) const { return component_[c]; }

    Rows<Real> view() {
        auto& c = component_;
        return {{c[0].data(), c[1].data(), c[2].data(), c[3].data(), c[4].data(), c[5].data()}, stride_, grid_.rows};
    }

    /// The same for reading only; the pointers are not const because rows are one type.
    Rows<Real> view() const { return const_cast<Cloth*>(this)->view(); }

    glm::dvec3 position(int i, int j) const { return triple(0, i, j); }
    glm::dvec3 velocity(int i, int j) const { return triple(3, i, j); }
    void set_position(int i, int j, const glm::dvec3& p) { set_triple(0, i, j, p); }
    void set_velocity(int i, int j, const glm::dvec3& v) { set_triple(3, i, j, v); }

private:
    // Components of a power-of-two grid would all start at the same place of the first-level cache and evict one
    // another; each starts a few cache lines further on than the one before.
    static constexpr std::size_t component_shift_bytes = 11 * row_alignment;

    std::size_t index(int i, int j) const { return static_cast<std::size_t>(j) * stride_ + i; }
    glm::dvec3 triple(int c, int i, int j) const {
        const auto n = index(i, j);
        return {component_[c][n], component_[c + 1][n], component_[c + 2][n]};
    }
    void set_triple(int c, int i, int j, const glm::dvec3& p) {
        const auto n = index(i, j);
        for (int k = 0; k < 3; ++k) component_[c + k][n] = static_cast<Real>(p[k]);
    }

    Grid grid_;
    int stride_;
    Array<Real> component_[6];
};

}  // namespace drapeau
