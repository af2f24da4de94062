// Sliders: what a bar's places mean, how numbers are written and read, and what a double click is; where tips stand.
#include "catch.hpp"

#include "viewer/double_press.hpp"
#include "viewer/slider_scale.hpp"
#include "viewer/tip_place.hpp"

#include <random>

using namespace drapeau;

TEST_CASE("a bar's places and its values are each other's inverse, and its ends are exact", "[slider]") {
    for (const SliderScale& scale : {SliderScale{.low = -30.0, .high = 30.0}, SliderScale{.low = 0.0, .high = 50.0},
                                     SliderScale{.low = 1e-6, .high = 0.1, .logarithmic = true}}) {
        CAPTURE(scale.low, scale.high);
        CHECK(value_at(0.0, scale) == scale.low);
        CHECK(value_at(1.0, scale) == scale.high);
        CHECK(value_at(-3.0, scale) == scale.low);
        for (double share = 0.05; share < 1.0; share += 0.05)
            CHECK(share_of(value_at(share, scale), scale) == Approx(share).margin(1e-12));
        CHECK(share_of(10.0 * scale.high, scale) == 1.0);
    }
    const SliderScale whole{.low = 1.0, .high = 200.0, .whole = true};
    CHECK(value_at(0.5, whole) == 101.0);
}

TEST_CASE("numbers stand with their unit and without long exponents, and are read as they are typed", "[slider]") {
    CHECK(number_text(1234.5, "%.6g N/m") == "1234.5 N/m");
    CHECK(number_text(20000.0, "%.4g N/m") == "20000 N/m");
    CHECK(number_text(12345.0, "%.4g N/m") == "12345 N/m");
    CHECK(number_text(-3e9, "%.4g N/m") == "-3e9 N/m");
    CHECK(number_text(1.23e-5, "%.3g N\xc2\xb7s/m") == "1.23e-5 N\xc2\xb7s/m");
    CHECK(number_text(10.0, "%.0f %%") == "10 %");
    CHECK(number_text(45.0, "%.0f") == "45");
    CHECK(number_text(0.4, "%.0f %%") == "0.4 %");
    CHECK(number_text(2.5, "%.0f %%") == "2.5 %");
    CHECK(number_text(12.5, "%.0f %%") == "12 %");
    CHECK(unit_of("%.0f %%") == "%");
    CHECK(unit_of("%.3g N\xc2\xb7s/m") == "N\xc2\xb7s/m");
    CHECK(unit_of("%.0f").empty());
    CHECK(typed_number(" 0.75") == 0.75);
    CHECK(typed_number("+1e-3") == 1e-3);
    CHECK(typed_number("2.") == 2.0);
    for (const char* none : {"", "-", "e5", ".", "nan", "inf", "1e999", "2 m", "2x"}) CHECK_FALSE(typed_number(none));
}

TEST_CASE("a number may be typed with its unit, in another prefix too, and not with another unit", "[slider]") {
    CHECK(typed_number("150 cm", "m") == Approx(1.5));
    CHECK(typed_number("1.5m", "m") == 1.5);
    CHECK(typed_number("2 m", "mm") == 2000.0);
    CHECK(typed_number("1e-1 m", "mm") == Approx(100.0));
    CHECK(typed_number("20 \xc2\xb5s", "ms") == Approx(0.02));
    CHECK(typed_number("20 us", "ms") == Approx(0.02));
    CHECK(typed_number("3 kN/m", "N/m") == 3000.0);
    CHECK(typed_number("5 mN s/m", "N\xc2\xb7s/m") == Approx(0.005));
    CHECK(typed_number("0.1 kg/m\xc2\xb2", "g/m\xc2\xb2") == Approx(100.0));
    CHECK(typed_number("50 g", "kg") == Approx(0.05));
    CHECK(typed_number("981 cm/s\xc2\xb2", "m/s\xc2\xb2") == Approx(9.81));
    CHECK(typed_number("40 %", "%") == 40.0);
    const std::pair<const char*, const char*> others[] = {
        {"2 ft", "m"},    {"2 min", "s"},    {"2 s", "m"}, {"2 m/s", "m"}, {"2 s", "m/s"},
        {"2 /s", "m/s"},  {"2 N/cm", "N/m"}, {"2 m", ""},  {"2 k", "N"},   {"2 cm\xc2\xb2", "m\xc2\xb2"},
        {"1e308 km", "m"}};
    for (const auto& [text, unit] : others) {
        CAPTURE(text, unit);
        CHECK_FALSE(typed_number(text, unit));
    }
}

TEST_CASE("two presses at one place are a double click if they may have been near in time", "[slider]") {
    const auto press = [](double earliest, double time, float x) {
        InputEvent event;
        event.kind = InputEvent::Kind::press;
        event.button = MouseButton::left;
        event.waited = time - earliest;
        event.time = time;
        event.at = {x, 10.0f};
        return event;
    };
    DoublePress fast, apart, late, slow, third;
    CHECK_FALSE(fast.in({press(1.0, 1.0, 5.0f)}));
    CHECK(fast.in({press(1.2, 1.2, 5.0f)}));
    CHECK_FALSE(apart.in({press(1.0, 1.0, 5.0f), press(1.1, 1.1, 50.0f)}));
    CHECK_FALSE(late.in({press(1.0, 1.0, 5.0f), press(2.0, 2.0, 5.0f)}));
    // A frame of a second lay between: the second press had waited in it.
    CHECK_FALSE(slow.in({press(1.0, 1.0, 5.0f)}));
    CHECK(slow.in({press(1.01, 2.0, 5.0f)}));
    CHECK(third.in({press(1.0, 1.0, 5.0f), press(1.0, 1.0, 5.0f)}));
    CHECK_FALSE(third.in({press(1.1, 1.1, 5.0f)}));  // it begins anew
}

TEST_CASE("a tip stands beside the box of its control and within the window wherever there is room", "[slider]") {
    std::mt19937 random(5);
    const auto between = [&](float low, float high) {
        return std::uniform_real_distribution<float>(low, high)(random);
    };
    const glm::vec2 window(900.0f, 640.0f);
    constexpr float gap = 7.0f;
    for (int n = 0; n < 2000; ++n) {
        Area box;
        box.x0 = between(0.0f, 700.0f), box.y0 = between(0.0f, 500.0f);
        box.x1 = between(box.x0 + 20.0f, 900.0f), box.y1 = between(box.y0 + 20.0f, 640.0f);
        const float y = between(box.y0, box.y1 - 10.0f);
        const Area control{box.x0 + 5.0f, y, box.x1 - 5.0f, y + 10.0f};
        const float width = tip_width(box, window, gap, 350.0f, 150.0f);
        const glm::vec2 size(width, between(20.0f, 300.0f)), corner = tip_corner(box, control, size, window, gap);
        const Area tip{corner.x, corner.y, corner.x + size.x, corner.y + size.y};
        CAPTURE(box.x0, box.y0, box.x1, box.y1, size.x, size.y, tip.x0, tip.y0);
        CHECK(tip.x0 >= 0.0f);
        CHECK(tip.y0 >= 0.0f);
        CHECK(tip.x1 <= window.x);
        CHECK(tip.y1 <= window.y);
        const auto over = [&tip](const Area& other) {
            return tip.x0 < other.x1 && tip.x1 > other.x0 && tip.y0 < other.y1 && tip.y1 > other.y0;
        };
        const bool has_room = std::max(window.x - box.x1, box.x0) >= 150.0f + 2.0f * gap;
        if (has_room) CHECK_FALSE(over(box));
    }
}
