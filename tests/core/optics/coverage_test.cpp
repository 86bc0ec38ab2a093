// Coverage of a lobe by a region: against a quarter of a million directions of that lobe, and the laws that areas obey.
#include "core/optics/lobe_profile.hpp"
#include "tests/core/support/random.hpp"
#include "tests/core/support/rays.hpp"
#include "tests/core/support/widths.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace zerkalo::test {
namespace {

constexpr double kTurn = 2 * 3.14159265358979323846;
constexpr double kExponents[] = {0, 0.5, 1, 2.5, 10, 100, 1000, 1e4, 1e6};
constexpr int kMostCorners = 6;

/// Stated in core/optics/README.md: the profile's fit, and the 2^-12 of the lobe that it leaves out.
double error_bound(double exponent) { return exponent < 0.5 ? 6e-4 : 1e-4; }

/// An angle that half of the lobe lies within, about.
double width_of(double exponent) { return 1 / std::sqrt(exponent + 1); }

/// A convex spherical polygon, its corners at any distance, its axis tilted against the lobe's.
struct Polygon {
    std::vector<Exact3> corners;
};

Polygon random_polygon(Random& random, double exponent) {
    const double width = width_of(exponent);
    const double size = std::min(1.2, width * std::exp2(random.uniform(-2, 4)));
    const double tilt = std::min(1.5, random.uniform(0, 1) * (std::tan(std::min(size, 1.2)) + 4 * width));
    const double turn = random.uniform(0, kTurn), start = random.uniform(0, kTurn);
    const Exact3 axis{std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn), std::cos(tilt)};
    const Exact3 side{-std::sin(turn), std::cos(turn), 0};
    const Exact3 up{-std::cos(tilt) * std::cos(turn), -std::cos(tilt) * std::sin(turn), std::sin(tilt)};
    Polygon polygon;
    const int count = 3 + random.below(kMostCorners - 2);
    for (int c = 0; c < count; ++c) {
        const double angle = start + kTurn * c / count, away = std::tan(size);
        const double x = away * std::cos(angle), y = 0.7 * away * std::sin(angle), far = random.uniform(0.5, 2);
        polygon.corners.push_back({(axis.x + side.x * x + up.x * y) * far, (axis.y + side.y * x + up.y * y) * far,
                                   (axis.z + side.z * x + up.z * y) * far});
    }
    return polygon;
}

/// Directions of the lobe: a lattice of `count`.
std::vector<Exact3> directions_of(double exponent, int count) {
    std::vector<Exact3> directions;
    for (int i = 0; i < count; ++i) {
        const double lost = -std::expm1(std::log((i + 0.5) / count) / (exponent + 1));
        const double across = std::sqrt(lost * (2 - lost)), turn = std::fmod(i * 0.61803398874989484820, 1) * kTurn;
        directions.push_back({across * std::cos(turn), across * std::sin(turn), 1 - lost});
    }
    return directions;
}

/// Share of the directions for which `inside` holds.
template <class Inside>
double share_of(const std::vector<Exact3>& directions, const Inside& inside) {
    return double(std::count_if(directions.begin(), directions.end(), inside)) / double(directions.size());
}

bool is_inside(const Polygon& polygon, const Exact3& d) {
    for (std::size_t c = 0; c < polygon.corners.size(); ++c) {
        const Exact3 &a = polygon.corners[c], &b = polygon.corners[(c + 1) % polygon.corners.size()];
        if (dot(cross(a, b), d) < 0) return false;
    }
    return true;
}

/// All with the same number of corners; padded with the last one.
Floats coverage_of(const probes::CoverageProbes& probes, const LobeProfile& profile, std::vector<Polygon> polygons) {
    while (polygons.size() % probes::kWidest != 0) polygons.push_back(polygons.back());
    const std::size_t count = polygons.front().corners.size();
    std::vector<PointList> corners(count);
    for (const Polygon& polygon : polygons) {
        for (std::size_t c = 0; c < count; ++c) corners[c].add(polygon.corners[c]);
    }
    const std::vector<probes::Points> points(corners.begin(), corners.end());
    Floats out(polygons.size());
    probes.polygon(profile, points.data(), static_cast<int>(count), out.data(), static_cast<int>(out.size()));
    return out;
}

class Coverage : public Widths {
protected:
    static float of_polygon(const LobeProfile& profile, const Polygon& polygon) {
        return coverage_of(coverage(), profile, {polygon}).front();
    }
};

const probes::CoverageProbes& one_lane() { return probes::kProbes_scalar.wide.coverage; }

constexpr int kDirections = 1 << 18;
constexpr double kLatticeError = 1.5e-4;  // of that many directions, at an edge

// One width is enough: the others have the same bits.
TEST(CoverageInOneLane, OfAPolygonIsItsShareOfTheLobesDirections) {
    Random random(401);
    for (const double n : kExponents) {
        const LobeProfile profile = profile_of(n);
        const std::vector<Exact3> directions = directions_of(n, kDirections);
        for (int round = 0; round < 6; ++round) {
            const Polygon polygon = random_polygon(random, n);
            const auto inside = [&](const Exact3& d) { return is_inside(polygon, d); };
            const double wanted = share_of(directions, inside);
            ASSERT_NEAR(coverage_of(one_lane(), profile, {polygon}).front(), wanted, error_bound(n) + kLatticeError)
                << "n " << n << ", polygon " << round << " of " << polygon.corners.size() << " corners";
        }
    }
}

struct Balls {
    Floats across, along, radius;
    void add(double tilt, double half_angle) {
        constexpr double kDistance = 3;
        across.push_back(float(kDistance * std::sin(tilt)));
        along.push_back(float(kDistance * std::cos(tilt)));
        radius.push_back(float(kDistance * std::sin(half_angle)));
    }
    int count() const { return static_cast<int>(across.size()); }
};

void of_balls(const probes::CoverageProbes& probes, const LobeProfile& profile, const Balls& balls, Floats& out) {
    probes.ball(profile, balls.across.data(), balls.along.data(), balls.radius.data(), out.data(), balls.count());
}
void of_rims(const probes::CoverageProbes& probes, const LobeProfile& profile, const Balls& balls, int panels,
             Floats& out) {
    probes.rim(profile, balls.across.data(), balls.along.data(), balls.radius.data(), panels, out.data(),
               balls.count());
}

Balls random_balls(Random& random, double exponent, int count) {
    Balls balls;
    for (int k = 0; k < count; ++k) {
        const double size = std::min(1.2, width_of(exponent) * std::exp2(random.uniform(-3, 4)));
        balls.add(std::min(1.6, random.uniform(0, 1) * (size + 4 * width_of(exponent))), size);
    }
    return balls;
}

TEST(CoverageInOneLane, OfABallIsItsShareOfTheLobesDirections) {
    Random random(402);
    for (const double n : kExponents) {
        const Balls balls = random_balls(random, n, probes::kWidest);
        Floats out(balls.across.size());
        of_balls(one_lane(), profile_of(n), balls, out);
        const std::vector<Exact3> directions = directions_of(n, kDirections);
        for (std::size_t k = 0; k < out.size(); ++k) {
            const double x = balls.across[k], z = balls.along[k], far2 = x * x + z * z;
            const double nearest2 = far2 - double(balls.radius[k]) * balls.radius[k];
            const double wanted = share_of(directions, [&](const Exact3& d) {
                const double along = double(d.x) * x + double(d.z) * z;
                return along > 0 && along * along >= nearest2;
            });
            ASSERT_NEAR(out[k], wanted, error_bound(n) + kLatticeError)
                << "n " << n << " across " << x << " along " << z << " radius " << balls.radius[k];
        }
    }
}

TEST_P(Coverage, OfABallIsThatOfTheConicArcsOfItsOutline) {
    Random random(403);
    for (const double n : kExponents) {
        constexpr int kBalls = 64 * probes::kWidest;
        const Balls balls = random_balls(random, n, kBalls);
        Floats ball(kBalls), rim(kBalls);
        of_balls(coverage(), profile_of(n), balls, ball);
        of_rims(coverage(), profile_of(n), balls, 16, rim);
        for (std::size_t k = 0; k < kBalls; ++k) {
            // The outline of a ball whose edge is seen beside the apex or behind it leaves the plane before it.
            if (std::atan2(balls.across[k], balls.along[k]) + std::asin(balls.radius[k] / 3) > 1.5) continue;
            ASSERT_NEAR(ball[k], rim[k], 2 * error_bound(n))
                << "n " << n << " across " << balls.across[k] << " along " << balls.along[k] << " radius "
                << balls.radius[k];
        }
    }
}

TEST_P(Coverage, OfAMirrorImageIsTheSame) {
    Random random(404);
    for (const double n : kExponents) {
        for (int round = 0; round < 200; ++round) {
            const Polygon polygon = random_polygon(random, n);
            Polygon image;
            for (std::size_t c = polygon.corners.size(); c-- > 0;) {
                const Exact3& p = polygon.corners[c];
                image.corners.push_back({-p.x, p.y, p.z});
            }
            ASSERT_NEAR(of_polygon(profile_of(n), polygon), of_polygon(profile_of(n), image), 4e-6) << "n " << n;
        }
    }
}

TEST_P(Coverage, OfTwoPartsIsThatOfTheWhole) {
    Random random(405);
    for (const double n : kExponents) {
        for (int round = 0; round < 200; ++round) {
            const Polygon whole = random_polygon(random, n);
            // From one corner to a place on an edge that does not touch it.
            const auto cut = 1 + static_cast<std::size_t>(random.below(static_cast<int>(whole.corners.size()) - 2));
            const double t = random.uniform(0.01, 0.99);
            const Exact3 &a = whole.corners[cut], &b = whole.corners[cut + 1];
            const Exact3 place{a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, a.z + (b.z - a.z) * t};
            Polygon first, second;
            for (std::size_t c = 0; c <= cut; ++c) first.corners.push_back(whole.corners[c]);
            first.corners.push_back(place);
            second.corners = {whole.corners[0], place};
            for (std::size_t c = cut + 1; c < whole.corners.size(); ++c) second.corners.push_back(whole.corners[c]);
            const LobeProfile profile = profile_of(n);
            // An edge in two pieces is integrated by twice the nodes: what is left is the error of eight.
            ASSERT_NEAR(of_polygon(profile, first) + of_polygon(profile, second), of_polygon(profile, whole),
                        error_bound(n)) << "n " << n;
        }
    }
}

TEST_P(Coverage, OfEverythingIsOneAndOfNothingZero) {
    for (const double n : kExponents) {
        const LobeProfile profile = profile_of(n);
        const double wide = 1.2 * std::sqrt(double(profile.tangent2));
        Polygon around, beside;
        for (int c = 0; c < 3; ++c) {
            const double angle = kTurn * c / 3;
            around.corners.push_back({2 * wide * std::cos(angle), 2 * wide * std::sin(angle), 1});
            beside.corners.push_back({wide * (4 + 2 * std::cos(angle)), 2 * wide * std::sin(angle), 1});
        }
        EXPECT_EQ(of_polygon(profile, around), 1) << "n " << n;
        EXPECT_EQ(of_polygon(profile, beside), 0) << "n " << n;
    }
}

TEST_P(Coverage, TurnIsTheArcTangent) {
    Random random(406);
    Floats y, x, out(kLawRays);
    while (y.size() < kLawRays) {
        y.push_back(float(random.uniform(-1, 1) * std::exp2(random.uniform(-60, 60))));
        x.push_back(float(random.uniform(-1, 1) * std::exp2(random.uniform(-60, 60))));
    }
    x[0] = y[0] = 0;
    coverage().turn(y.data(), x.data(), out.data(), static_cast<int>(kLawRays));
    for (std::size_t k = 0; k < kLawRays; ++k) {
        ASSERT_NEAR(out[k], std::atan2(double(y[k]), double(x[k])) / kTurn, 6e-7) << y[k] << ", " << x[k];
    }
}

TEST_P(Coverage, EveryWidthGivesTheSameBits) {
    Random random(407);
    for (const double n : kExponents) {
        const LobeProfile profile = profile_of(n);
        std::vector<Polygon> polygons;
        while (polygons.size() < 160) {
            Polygon polygon = random_polygon(random, n);
            polygon.corners.resize(3);
            polygons.push_back(polygon);
        }
        expect_same_bits(coverage_of(coverage(), profile, polygons), coverage_of(scalar().coverage, profile, polygons),
                         "polygon");
        const Balls balls = random_balls(random, n, 160);
        Floats here(160), there(160);
        of_balls(coverage(), profile, balls, here);
        of_balls(scalar().coverage, profile, balls, there);
        expect_same_bits(here, there, "ball");
        of_rims(coverage(), profile, balls, 3, here);
        of_rims(scalar().coverage, profile, balls, 3, there);
        expect_same_bits(here, there, "rim");
    }
}

ZERKALO_OVER_ALL_WIDTHS(Coverage);

}  // namespace
}  // namespace zerkalo::test
