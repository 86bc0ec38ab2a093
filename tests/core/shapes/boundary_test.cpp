// The outline of a mirror: half-open edges, abutting rectangles tile the plane, every shape is its formula.
#include "tests/core/support/rays.hpp"
#include "tests/core/support/solids.hpp"
#include "tests/core/support/widths.hpp"

namespace zerkalo::test {
namespace {

class MirrorOutline : public Widths {
protected:
    static Floats inside(const BoundaryData& b, const Floats& x, const Floats& y) {
        Floats answer(x.size());
        shapes().inside(b, x.data(), y.data(), answer.data(), static_cast<int>(x.size()));
        return answer;
    }
};

BoundaryData outline_of(const Boundary& boundary) {
    const auto scene = std::make_unique<Scene>();
    const auto plan = std::make_unique<Plan>();
    scene->mirror_count = 1;
    scene->mirrors[0].boundary = boundary;
    const Status status = prepare(*scene, Settings{}, *plan);
    EXPECT_TRUE(status.ok()) << status.field << " " << status.reason;
    return plan->mirrors[0].shape.boundary;
}

TEST_P(MirrorOutline, RectangleHasItsLowEdgesAndNotItsHighOnes) {
    const BoundaryData b = outline_of({.shape = BoundaryShape::rectangle, .width = 2, .height = 1});
    const float over = std::nextafter(1.0f, 2.0f), under = std::nextafter(1.0f, 0.0f);
    const Floats x{-1, 1, -over, under, 0, 0, 0, 0, -1, 1, -1, 1, 0, 0, 0, 0};
    const Floats y{0, 0, 0, 0, -0.5f, 0.5f, -0.5f * over, 0.5f * under, -0.5f, -0.5f, 0.5f, 0.5f, 0, 0, 0, 0};
    expect_same_bits(inside(b, x, y), Floats{1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 0, 1, 1, 1, 1}, "rectangle");
}

// A strip of rectangles side by side, each with its own shifted coordinates: every point belongs to exactly one.
TEST_P(MirrorOutline, AbuttingRectanglesTile) {
    const BoundaryData b = outline_of({.shape = BoundaryShape::rectangle, .width = 0.5, .height = 0.25});
    Random random(51);
    Floats x, y;
    while (x.size() < kLawRays) {
        // A grid of 2^-6 holds every edge exactly, so half of the points lie on one.
        x.push_back(float(random.below(96) - 48) / 64), y.push_back(float(random.below(48) - 24) / 64);
    }
    Floats covered(x.size(), 0);
    for (int column = -2; column <= 2; ++column) {
        for (int row = -2; row <= 2; ++row) {
            Floats u = x, v = y;
            for (float& value : u) value -= 0.5f * float(column);
            for (float& value : v) value -= 0.25f * float(row);
            const Floats one = inside(b, u, v);
            for (std::size_t k = 0; k < one.size(); ++k) covered[k] += one[k];
        }
    }
    expect_same_bits(covered, Floats(x.size(), 1), "number of mirrors that own a point");
}

TEST_P(MirrorOutline, DiscAndEllipseAreTheirFormula) {
    Random random(52);
    constexpr Real80 kRoundings = 6;  // two products, two squares, a sum
    const Boundary shapes_of[] = {{.shape = BoundaryShape::disc, .radius = 0.75},
                                  {.shape = BoundaryShape::ellipse, .width = 3, .height = 0.5}};
    for (const Boundary& shape : shapes_of) {
        const BoundaryData b = outline_of(shape);
        const bool disc = shape.shape == BoundaryShape::disc;
        const Real80 semi_x = disc ? shape.radius : shape.width / 2, semi_y = disc ? shape.radius : shape.height / 2;
        Floats x, y;
        while (x.size() < kLawRays) {
            const double around = random.uniform(0, 6.3),
                         out = 1 + random.uniform(-1, 1) * std::exp2(random.uniform(-24, 0));
            x.push_back(float(double(semi_x) * out * std::cos(around)));
            y.push_back(float(double(semi_y) * out * std::sin(around)));
        }
        const Floats answer = inside(b, x, y);
        std::size_t decided[2] = {0, 0};
        for (std::size_t k = 0; k < x.size(); ++k) {
            const Real80 u = x[k] / semi_x, v = y[k] / semi_y, excess = u * u + v * v - 1;
            if (std::abs(excess) <= kRoundings * kU) continue;
            ASSERT_EQ(answer[k], excess < 0 ? 1 : 0) << std::hexfloat << x[k] << " " << y[k];
            ++decided[excess < 0];
        }
        EXPECT_GT(decided[0], x.size() / 4);
        EXPECT_GT(decided[1], x.size() / 4);
    }
}

TEST_P(MirrorOutline, DiscTouchesItsRim) {
    const BoundaryData b = outline_of({.shape = BoundaryShape::disc, .radius = 1});
    const float over = std::nextafter(1.0f, 2.0f);
    const Floats x{1, -1, 0, 0, over, -over, 0, 0, 0.6f, 0, 0, 0, 0, 0, 0, 0};
    const Floats y{0, 0, 1, -1, 0, 0, over, -over, 0.79f, 0, 0, 0, 0, 0, 0, 0};
    expect_same_bits(inside(b, x, y), Floats{1, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1}, "disc");
}

TEST_P(MirrorOutline, PolygonIsTheSameInEitherSense) {
    Random random(53);
    constexpr Real80 kRoundings = 8;  // the edge's normal and offset are rounded, then two products and a sum
    for (const int corners : {3, 5, 16}) {
        Boundary forwards{.shape = BoundaryShape::polygon, .corner_count = corners};
        for (int k = 0; k < corners; ++k) {
            const double angle = 2 * 3.14159265358979323846 * (k + 0.3 * std::sin(k)) / corners;
            forwards.corners[k] = {1.5 * std::cos(angle), std::sin(angle)};
        }
        Boundary backwards = forwards;
        std::reverse(backwards.corners, backwards.corners + corners);
        Floats x, y;
        while (x.size() < kLawRays / 4)
            x.push_back(float(random.uniform(-2, 2))), y.push_back(float(random.uniform(-2, 2)));
        x.resize((x.size() + 15) / 16 * 16, 0), y.resize(x.size(), 0);
        const Floats one = inside(outline_of(forwards), x, y), other = inside(outline_of(backwards), x, y);
        std::size_t within = 0;
        for (std::size_t k = 0; k < x.size(); ++k) {
            Real80 nearest = kFar80;
            for (int e = 0; e < corners; ++e) {
                const auto& p = forwards.corners[e];
                const auto& q = forwards.corners[(e + 1) % corners];
                const Real80 side =
                    (q.x - Real80(p.x)) * (y[k] - Real80(p.y)) - (q.y - Real80(p.y)) * (x[k] - Real80(p.x));
                nearest = std::min(nearest, side);
            }
            if (std::abs(nearest) <= kRoundings * kU * 4) continue;
            ASSERT_EQ(one[k], nearest > 0 ? 1 : 0) << std::hexfloat << x[k] << " " << y[k];
            ASSERT_EQ(other[k], one[k]) << std::hexfloat << x[k] << " " << y[k];
            within += nearest > 0;
        }
        EXPECT_GT(within, x.size() / 10);
    }
}

ZERKALO_OVER_ALL_WIDTHS(MirrorOutline);

}  // namespace
}  // namespace zerkalo::test
