// What a key does to a scene: the seed's matrices as printed, degrees, and the exponent that belongs to a polish.
#include "core/scene/edit.hpp"

#include "core/geometry/frame.hpp"
#include "tests/core/support/random.hpp"

#include <gtest/gtest.h>

namespace zerkalo::test {
namespace {

// A product of three matrices whose entries are within 1e-15.
constexpr Real80 kRoom = 8e-15L;

TEST(Edit, MoveShiftsThePositionAlone) {
    Camera camera;
    camera.position = {1, 2, 3}, camera.view = {0, 0, -2}, camera.fov = 0.5;
    const Camera there = moved(camera, {0.5, -1, 4});
    EXPECT_EQ(length(there.position - Vec3<double>{1.5, 1, 7}), 0);
    EXPECT_EQ(length(there.view - camera.view), 0);
    EXPECT_EQ(length(there.up - camera.up), 0);
    EXPECT_EQ(there.fov, camera.fov);
    Light light;
    light.position = {1, 2, 3}, light.intensity = 7;
    const Light lamp = moved(light, {0.5, -1, 4});
    EXPECT_EQ(length(lamp.position - Vec3<double>{1.5, 1, 7}), 0);
    EXPECT_EQ(lamp.intensity, 7);
}

/// Matrices 2.12-2.14 for column vectors: rows of R_x, R_y, R_z at angle a.
struct Matrix {
    Exact3 rows[3];
    Exact3 operator*(const Exact3& v) const { return {dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)}; }
};
Matrix about_x(Real80 a) { return {{{1, 0, 0}, {0, std::cos(a), -std::sin(a)}, {0, std::sin(a), std::cos(a)}}}; }
Matrix about_y(Real80 a) { return {{{std::cos(a), 0, std::sin(a)}, {0, 1, 0}, {-std::sin(a), 0, std::cos(a)}}}; }
Matrix about_z(Real80 a) { return {{{std::cos(a), -std::sin(a), 0}, {std::sin(a), std::cos(a), 0}, {0, 0, 1}}}; }

TEST(Edit, TurnIsTheSeedsMatricesAboutXThenYThenZ) {
    Random random(101);
    for (int k = 0; k < 1000; ++k) {
        const Vec3<double> angles{random.uniform(-7, 7), random.uniform(-7, 7), random.uniform(-7, 7)};
        Camera camera;
        camera.position = {5, 6, 7};
        camera.view = rounded_to_double(random.direction()), camera.up = rounded_to_double(random.direction());
        const Camera there = turned(camera, angles);
        const auto turn = [&](const Vec3<double>& v) {
            return about_z(angles.z) * (about_y(angles.y) * (about_x(angles.x) * exact(v)));
        };
        ASSERT_LE(length(exact(there.view) - turn(camera.view)), kRoom)
            << angles.x << " " << angles.y << " " << angles.z;
        ASSERT_LE(length(exact(there.up) - turn(camera.up)), kRoom) << angles.x << " " << angles.y << " " << angles.z;
        ASSERT_EQ(length(there.position - camera.position), 0);
    }
}

TEST(Edit, QuarterTurnsSendAxesToAxes) {
    const double quarter = radians(90);
    const Exact3 x = exact(rotated({0, 1, 0}, {quarter, 0, 0})), y = exact(rotated({0, 0, 1}, {0, quarter, 0})),
                 z = exact(rotated({1, 0, 0}, {0, 0, quarter}));
    EXPECT_LE(length(x - Exact3{0, 0, 1}), kRoom);
    EXPECT_LE(length(y - Exact3{1, 0, 0}), kRoom);
    EXPECT_LE(length(z - Exact3{0, 1, 0}), kRoom);
    // x first: the order cannot be told from one angle alone.
    EXPECT_LE(length(exact(rotated({0, 1, 0}, {quarter, quarter, quarter})) - Exact3{0, 1, 0}), kRoom);
}

TEST(Edit, RadiansAreDegreesOfOneTurn) {
    constexpr Real80 kDegree = kPi80 / 180;
    Random random(102);
    for (int k = 0; k < 10000; ++k) {
        const double degrees = random.uniform(-360, 360);
        ASSERT_LE(std::abs(radians(degrees) - degrees * kDegree), 1e-15L * std::abs(degrees * kDegree)) << degrees;
    }
    EXPECT_EQ(radians(0), 0);
    EXPECT_EQ(radians(360 * 1e6 + 30), radians(30));
    EXPECT_EQ(radians(-360 * 1e6 - 30), radians(-30));
    EXPECT_EQ(radians(1e300), 0) << "more turns than a double can count";
}

TEST(Edit, PolishRaisesTheExponentFromZeroToInfinity) {
    EXPECT_EQ(exponent_of_polish(0), 0);
    EXPECT_EQ(exponent_of_polish(0.5), 7.5);
    EXPECT_EQ(exponent_of_polish(1), kInfinity);
    double before = -1;
    for (int k = 0; k <= 10000; ++k) {
        const double exponent = exponent_of_polish(k / 10000.0);
        ASSERT_GT(exponent, before) << "polish " << k / 10000.0;
        before = exponent;
    }
}

TEST(Edit, PolishOutsideOfZeroToOneIsNoNumber) {
    for (const double polish : {-0.5, -1e-30, 1.0000001, 1.5, kInfinity, -kInfinity}) {
        EXPECT_TRUE(std::isnan(exponent_of_polish(polish))) << polish;
    }
    EXPECT_TRUE(std::isnan(exponent_of_polish(std::numeric_limits<double>::quiet_NaN())));
}

}  // namespace
}  // namespace zerkalo::test
