// Times coordinate conversions of GeographicLib and PROJ: tests/clients/geodesy_speed.sh runs it beside Orb.
// One line a conversion: library, conversion, nanoseconds a point (best of 5 rounds), checksum.
#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/LocalCartesian.hpp>
#include <GeographicLib/MGRS.hpp>
#include <GeographicLib/UTMUPS.hpp>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <proj.h>
#include <string>
#include <vector>

struct Point { double a, b, c; };

// The same points as Orb's bench: SplitMix64, seed 8.
static std::vector<Point> points(size_t n) {
    unsigned long long s = 8;
    auto next = [&] {
        unsigned long long z = s += 0x9E3779B97F4A7C15ull;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
        return double((z ^ (z >> 31)) >> 11) / 9007199254740992.0;
    };
    std::vector<Point> out(n);
    for (auto &p : out) {
        double u = next(), v = next(), w = next();
        p = {-79 + 162 * u, -180 + 360 * v, -10000 + 1010000 * w};
    }
    return out;
}

static void time_it(const char *library, const char *what, size_t n, const std::function<double()> &round) {
    double best = 1e300, sum = 0;
    for (int i = 0; i < 5; ++i) {
        auto t = std::chrono::steady_clock::now();
        sum = round();
        best = std::min(best, std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - t).count() / n);
    }
    std::printf("%-14s %-20s %8.1f ns  %.6e\n", library, what, best, sum);
}

int main(int argc, char **argv) {
    size_t n = argc > 1 ? std::stoul(argv[1]) : 200000;
    auto all = points(n);
    const auto &earth = GeographicLib::Geocentric::WGS84();
    std::vector<Point> ecef(n), grid(n);
    std::vector<int> zone(n);
    std::vector<bool> north(n);
    time_it("GeographicLib", "geodetic -> ecef", n, [&] {
        double s = 0;
        for (size_t i = 0; i < n; ++i) { earth.Forward(all[i].a, all[i].b, all[i].c, ecef[i].a, ecef[i].b, ecef[i].c); s += ecef[i].a; }
        return s;
    });
    time_it("GeographicLib", "ecef -> geodetic", n, [&] {
        double s = 0, lat, lon, h;
        for (auto &p : ecef) { earth.Reverse(p.a, p.b, p.c, lat, lon, h); s += lat + h; }
        return s;
    });
    GeographicLib::LocalCartesian here(34.5523, -118.4712, 740);
    std::vector<Point> enu(n), ups(n);
    time_it("GeographicLib", "geodetic -> enu", n, [&] {
        double s = 0;
        for (size_t i = 0; i < n; ++i) { here.Forward(all[i].a, all[i].b, all[i].c, enu[i].a, enu[i].b, enu[i].c); s += enu[i].a; }
        return s;
    });
    time_it("GeographicLib", "enu -> geodetic", n, [&] {
        double s = 0, lat, lon, h;
        for (auto &p : enu) { here.Reverse(p.a, p.b, p.c, lat, lon, h); s += lat; }
        return s;
    });
    time_it("GeographicLib", "geodetic -> utm", n, [&] {
        double s = 0;
        for (size_t i = 0; i < n; ++i) {
            int z; bool np;
            GeographicLib::UTMUPS::Forward(all[i].a, all[i].b, z, np, grid[i].a, grid[i].b);
            zone[i] = z; north[i] = np; s += grid[i].a;
        }
        return s;
    });
    time_it("GeographicLib", "utm -> geodetic", n, [&] {
        double s = 0, lat, lon;
        for (size_t i = 0; i < n; ++i) { GeographicLib::UTMUPS::Reverse(zone[i], north[i], grid[i].a, grid[i].b, lat, lon); s += lat; }
        return s;
    });
    // Where UPS is prescribed.
    std::vector<Point> polar(n);
    for (size_t i = 0; i < n; ++i) polar[i] = {all[i].a < 2 ? -90 + 10 * std::fabs(all[i].c) / 1e6 : 84 + 6 * std::fabs(all[i].c) / 1e6, all[i].b, 0};
    time_it("GeographicLib", "geodetic -> ups", n, [&] {
        double s = 0;
        for (size_t i = 0; i < n; ++i) {
            int z; bool np;
            GeographicLib::UTMUPS::Forward(polar[i].a, polar[i].b, z, np, ups[i].a, ups[i].b, GeographicLib::UTMUPS::UPS);
            ups[i].c = np; s += ups[i].a;
        }
        return s;
    });
    time_it("GeographicLib", "ups -> geodetic", n, [&] {
        double s = 0, lat, lon;
        for (auto &p : ups) { GeographicLib::UTMUPS::Reverse(0, p.c != 0, p.a, p.b, lat, lon); s += lat; }
        return s;
    });
    std::vector<std::string> references(n);
    for (size_t i = 0; i < n; ++i) {
        int z; bool np; double x, y;
        GeographicLib::UTMUPS::Forward(all[i].a, all[i].b, z, np, x, y);
        GeographicLib::MGRS::Forward(z, np, x, y, all[i].a, 5, references[i]);
    }
    time_it("GeographicLib", "mgrs -> geodetic", n, [&] {
        double s = 0, x, y, lat, lon; int z, digits; bool np;
        for (auto &text : references) {
            GeographicLib::MGRS::Reverse(text, z, np, x, y, digits);
            GeographicLib::UTMUPS::Reverse(z, np, x, y, lat, lon);
            s += lat;
        }
        return s;
    });
    time_it("GeographicLib", "geodetic -> mgrs", n, [&] {
        double s = 0, x, y; int z; bool np; std::string text;
        for (auto &p : all) {
            GeographicLib::UTMUPS::Forward(p.a, p.b, z, np, x, y);
            GeographicLib::MGRS::Forward(z, np, x, y, p.a, 5, text);
            s += text[6];
        }
        return s;
    });
    PJ_CONTEXT *c = proj_context_create();
    PJ *cart = proj_create(c, "+proj=pipeline +step +proj=unitconvert +xy_in=deg +xy_out=rad +step +proj=cart +ellps=WGS84");
    time_it("PROJ", "geodetic -> ecef", n, [&] {
        double s = 0;
        for (auto &p : all) s += proj_trans(cart, PJ_FWD, proj_coord(p.b, p.a, p.c, 0)).v[0];
        return s;
    });
    time_it("PROJ", "ecef -> geodetic", n, [&] {
        double s = 0;
        for (auto &p : ecef) { PJ_COORD o = proj_trans(cart, PJ_INV, proj_coord(p.a, p.b, p.c, 0)); s += o.v[1] + o.v[2]; }
        return s;
    });
    PJ *local = proj_create(c, "+proj=pipeline +step +proj=unitconvert +xy_in=deg +xy_out=rad +step +proj=cart +ellps=WGS84 "
                               "+step +proj=topocentric +ellps=WGS84 +lat_0=34.5523 +lon_0=-118.4712 +h_0=740");
    time_it("PROJ", "geodetic -> enu", n, [&] {
        double s = 0;
        for (auto &p : all) s += proj_trans(local, PJ_FWD, proj_coord(p.b, p.a, p.c, 0)).v[0];
        return s;
    });
    time_it("PROJ", "enu -> geodetic", n, [&] {
        double s = 0;
        for (auto &p : enu) s += proj_trans(local, PJ_INV, proj_coord(p.a, p.b, p.c, 0)).v[1];
        return s;
    });
    const char *pole = "+proj=pipeline +step +proj=unitconvert +xy_in=deg +xy_out=rad +step +proj=ups +ellps=WGS84 ";
    PJ *poles[2] = {proj_create(c, (std::string(pole) + "+south").c_str()), proj_create(c, pole)};
    time_it("PROJ", "geodetic -> ups", n, [&] {
        double s = 0;
        for (auto &p : polar) s += proj_trans(poles[p.a > 0], PJ_FWD, proj_coord(p.b, p.a, 0, 0)).v[0];
        return s;
    });
    time_it("PROJ", "ups -> geodetic", n, [&] {
        double s = 0;
        for (auto &p : ups) s += proj_trans(poles[p.c != 0], PJ_INV, proj_coord(p.a, p.b, 0, 0)).v[1];
        return s;
    });
    // PROJ takes one zone a transformation: 60 of them, chosen like Orb and GeographicLib choose.
    std::vector<PJ *> utm(61);
    for (int z = 1; z <= 60; ++z)
        utm[z] = proj_create(c, ("+proj=pipeline +step +proj=unitconvert +xy_in=deg +xy_out=rad +step +proj=utm +zone=" + std::to_string(z) + " +ellps=WGS84").c_str());
    time_it("PROJ", "geodetic -> utm", n, [&] {
        double s = 0;
        for (auto &p : all) s += proj_trans(utm[GeographicLib::UTMUPS::StandardZone(p.a, p.b)], PJ_FWD, proj_coord(p.b, p.a, 0, 0)).v[0];
        return s;
    });
    time_it("PROJ", "utm -> geodetic", n, [&] {
        double s = 0;
        for (size_t i = 0; i < n; ++i) s += proj_trans(utm[zone[i]], PJ_INV, proj_coord(grid[i].a, grid[i].b - (north[i] ? 0 : 1e7), 0, 0)).v[1];
        return s;
    });
}
