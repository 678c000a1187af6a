// Writes the room with every number at its scale.
#include "scaled_room.h"

#include <cstdio>
#include <sstream>
#include <vector>

namespace stress {
namespace {

using Point = std::array<double, 3>;

class RoomText {
  public:
    RoomText(const Placement& placement, int size) : at_(placement), size_(size) {}

    std::string text() {
        options();
        world();
        return out_.str();
    }

  private:
    static std::string number(double value) {
        std::array<char, 32> text{};
        std::snprintf(text.data(), text.size(), "%.17g", value);
        return text.data();
    }
    std::string length(double value) const { return number(value * at_.scale); }
    std::string point(const Point& p) const {
        std::string text;
        for (std::size_t axis = 0; axis < 3; ++axis)
            text += number(p[axis] * at_.scale + at_.origin[axis]) + ' ';
        return text;
    }
    void mesh(const char* triangles, const std::vector<Point>& corners) {
        out_ << "Shape \"trianglemesh\" \"integer triindices\" [" << triangles << "] \"point P\" [";
        for (const Point& corner : corners)
            out_ << point(corner);
        out_ << "]\n";
    }
    void options() {
        out_ << "Film \"fleximage\" \"integer xresolution\" [" << size_
             << "] \"integer yresolution\" [" << size_ << "]\nLookAt " << point({0, -3.6, 1})
             << point({0, 0, 1}) << "0 0 1\nCamera \"perspective\" \"float fov\" [39] "
             << "\"float hither\" [" << length(at_.hither_yon[0]) << "] \"float yon\" ["
             << length(at_.hither_yon[1]) << "]\n"
             << "PixelFilter \"box\"\nSampler \"random\"\nSurfaceIntegrator \"aips\"\n";
    }
    void world() {
        out_ << "WorldBegin\n"
                "MakeNamedMaterial \"white\" \"string type\" [\"matte\"] \"color Kd\" [0.7 0.7 "
                "0.7]\n"
                "MakeNamedMaterial \"red\" \"string type\" [\"matte\"] \"color Kd\" [0.6 0.1 0.1]\n"
                "MakeNamedMaterial \"glass\" \"string type\" [\"glass\"] \"float index\" [1.5]\n"
                "NamedMaterial \"white\"\n";
        mesh("0 1 2 0 2 3 4 6 5 4 7 6 3 2 6 3 6 7", {{-1, -1, 0},
                                                     {1, -1, 0},
                                                     {1, 1, 0},
                                                     {-1, 1, 0},
                                                     {-1, -1, 2},
                                                     {1, -1, 2},
                                                     {1, 1, 2},
                                                     {-1, 1, 2}});
        out_ << "NamedMaterial \"red\"\n";
        mesh("0 1 2 0 2 3 4 5 6 4 6 7", {{-1, -1, 0},
                                         {-1, -1, 2},
                                         {-1, 1, 2},
                                         {-1, 1, 0},
                                         {1, -1, 0},
                                         {1, 1, 0},
                                         {1, 1, 2},
                                         {1, -1, 2}});
        const std::string s = number(at_.scale) + ' ';
        out_ << "AttributeBegin\nTranslate " << point({-0.4, 0.3, 0.4}) << "\nScale " << s << s << s
             << "\nNamedMaterial \"white\" Shape \"sphere\" \"float radius\" [0.4]\nAttributeEnd\n"
             << "AttributeBegin\nTranslate " << point({0.45, -0.25, 0.35})
             << "\nNamedMaterial \"glass\" Shape \"sphere\" \"float radius\" [" << length(0.35)
             << "]\nAttributeEnd\nAttributeBegin\n"
             << "AreaLightSource \"area\" \"color L\" [14 13 11] \"float power\" [0] "
                "\"float efficacy\" [0]\nMaterial \"matte\" \"color Kd\" [0 0 0]\n";
        mesh("0 2 1 0 3 2",
             {{-0.3, -0.3, 1.99}, {0.3, -0.3, 1.99}, {0.3, 0.3, 1.99}, {-0.3, 0.3, 1.99}});
        const std::string intensity = number(2 * at_.scale * at_.scale) + ' ';
        out_ << "AttributeEnd\nLightSource \"point\" \"point from\" [" << point({0.6, 0.1, 1.6})
             << "] \"color L\" [" << intensity << intensity << intensity
             << "] \"float power\" [0] \"float efficacy\" [0]\nWorldEnd\n";
    }

    Placement at_;
    int size_;
    std::ostringstream out_;
};

}  // namespace

std::string scaled_room(const Placement& placement, int size) {
    return RoomText(placement, size).text();
}

}  // namespace stress
