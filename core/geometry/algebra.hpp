// Vector algebra over any mix of uniform and varying numbers. Sums are taken x, then y, then z, always.
#pragma once

#include "core/geometry/vec.hpp"
#include "core/numeric/number.hpp"

namespace zerkalo::inline ZERKALO_ISA {

template <class A, class B>
ZERKALO_INLINE auto operator+(Vec3<A> a, Vec3<B> b) -> Vec3<decltype(a.x + b.x)> {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class A, class B>
ZERKALO_INLINE auto operator-(Vec3<A> a, Vec3<B> b) -> Vec3<decltype(a.x - b.x)> {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class A>
ZERKALO_INLINE Vec3<A> operator-(Vec3<A> a) {
    return {-a.x, -a.y, -a.z};
}
template <class A, class B>
ZERKALO_INLINE auto operator*(Vec3<A> a, B s) -> Vec3<decltype(a.x * s)> {
    return {a.x * s, a.y * s, a.z * s};
}

template <class A, class B>
ZERKALO_INLINE auto dot(Vec3<A> a, Vec3<B> b) -> decltype(a.x * b.x) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class A, class B>
ZERKALO_INLINE auto cross(Vec3<A> a, Vec3<B> b) -> Vec3<decltype(a.x * b.x)> {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The vector in another format, component by component.
template <class To, class From>
ZERKALO_INLINE Vec3<To> as(Vec3<From> a) {
    return {as<To>(a.x), as<To>(a.y), as<To>(a.z)};
}
template <class To, class From>
ZERKALO_INLINE Rgb<To> as(Rgb<From> a) {
    return {as<To>(a.r), as<To>(a.g), as<To>(a.b)};
}

/// as<To>, a + b and a - b of vectors that are known to fit.
template <class To, class From>
ZERKALO_INLINE Vec3<To> rounded(Vec3<From> a) {
    return {rounded<To>(a.x), rounded<To>(a.y), rounded<To>(a.z)};
}
template <class To, class From>
ZERKALO_INLINE Rgb<To> rounded(Rgb<From> a) {
    return {rounded<To>(a.r), rounded<To>(a.g), rounded<To>(a.b)};
}
template <class A, class B>
ZERKALO_INLINE auto fitting_sum(Vec3<A> a, Vec3<B> b) -> Vec3<decltype(a.x + b.x)> {
    return {fitting_sum(a.x, b.x), fitting_sum(a.y, b.y), fitting_sum(a.z, b.z)};
}
template <class A, class B>
ZERKALO_INLINE auto fitting_difference(Vec3<A> a, Vec3<B> b) -> Vec3<decltype(a.x - b.x)> {
    return {fitting_difference(a.x, b.x), fitting_difference(a.y, b.y), fitting_difference(a.z, b.z)};
}
/// The dot product of two ways between points of the scene, at most 15 long.
template <class A, class B>
ZERKALO_INLINE auto dot_of_ways(Vec3<A> a, Vec3<B> b) -> decltype(a.x * b.x) {
    return fitting_sum(fitting_sum(a.x * b.x, a.y * b.y), a.z * b.z);
}

/// a s in the format To, and a dot product each of whose terms is rounded to To: where a product has no format.
template <class To, class A, class B>
ZERKALO_INLINE Vec3<To> product(Vec3<A> a, B s) {
    return {product<To>(a.x, s), product<To>(a.y, s), product<To>(a.z, s)};
}
template <class To, class A, class B>
ZERKALO_INLINE Vec3<To> rounded_product(Vec3<A> a, B s) {
    return {rounded_product<To>(a.x, s), rounded_product<To>(a.y, s), rounded_product<To>(a.z, s)};
}
template <class To, class A, class B>
ZERKALO_INLINE Rgb<To> product(Rgb<A> a, B s) {
    return {product<To>(a.r, s), product<To>(a.g, s), product<To>(a.b, s)};
}
template <class To, class A, class B>
ZERKALO_INLINE To dot_as(Vec3<A> a, Vec3<B> b) {
    return product<To>(a.x, b.x) + product<To>(a.y, b.y) + product<To>(a.z, b.z);
}

template <class M, class A>
ZERKALO_INLINE Vec3<A> select(M mask, Vec3<A> a, Vec3<A> b) {
    return {select(mask, a.x, b.x), select(mask, a.y, b.y), select(mask, a.z, b.z)};
}
template <class M, class A>
ZERKALO_INLINE Rgb<A> select(M mask, Rgb<A> a, Rgb<A> b) {
    return {select(mask, a.r, b.r), select(mask, a.g, b.g), select(mask, a.b, b.b)};
}

/// a + b in the lanes of the mask, a elsewhere; neither is negative.
template <class M, class A>
ZERKALO_INLINE A plus_where(M mask, A a, A b) {
    return select(mask, a + b, a);
}

template <class M, class A>
ZERKALO_INLINE Rgb<A> plus_where(M mask, Rgb<A> a, Rgb<A> b) {
    return {plus_where(mask, a.r, b.r), plus_where(mask, a.g, b.g), plus_where(mask, a.b, b.b)};
}

/// A uniform vector, the same in all lanes.
template <class R, class U>
ZERKALO_INLINE Vec3<R> spread(Vec3<U> a) {
    return {R(a.x), R(a.y), R(a.z)};
}
template <class R, class U>
ZERKALO_INLINE Rgb<R> spread(Rgb<U> a) {
    return {R(a.r), R(a.g), R(a.b)};
}

template <class A, class B>
ZERKALO_INLINE auto operator+(Rgb<A> a, Rgb<B> b) -> Rgb<decltype(a.r + b.r)> {
    return {a.r + b.r, a.g + b.g, a.b + b.b};
}
template <class A, class B>
ZERKALO_INLINE auto operator-(Rgb<A> a, Rgb<B> b) -> Rgb<decltype(a.r - b.r)> {
    return {a.r - b.r, a.g - b.g, a.b - b.b};
}
template <class A, class B>
ZERKALO_INLINE auto operator*(Rgb<A> a, Rgb<B> b) -> Rgb<decltype(a.r * b.r)> {
    return {a.r * b.r, a.g * b.g, a.b * b.b};
}
template <class A, class B>
ZERKALO_INLINE auto scaled(Rgb<A> a, B s) -> Rgb<decltype(a.r * s)> {
    return {a.r * s, a.g * s, a.b * s};
}

}  // namespace zerkalo::inline ZERKALO_ISA
