// Directives Shape, ObjectBegin, ObjectEnd and ObjectInstance.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "translator.h"

namespace lxs::pbrt {
namespace {

/// How far behind its front the back of a lamp that shines on both sides lies, of its extent.
constexpr double kBack = 1e-4;

constexpr const char* kTubes = "curves are tubes with smooth normals, hair of three sides";

/// Of a patch that is bent: sides of squares, which are two triangles each.
constexpr int kSquares = 8;
/// Where its fourth corner lies off the parallelogram of the others, of its extent.
constexpr double kBent = 1e-3;

/// Four values at the corners 00, 10, 01, 11.
template <class T>
T bilinear(const std::array<T, 4>& corners, double u, double v) {
    return (corners[0] * (1 - u) + corners[1] * u) * (1 - v) +
           (corners[2] * (1 - u) + corners[3] * u) * v;
}

/// Bilinear patches as triangles, with the normals that they have.
class PatchMesh {
  public:
    /// Lists as pbrt has them; `normals` and `uv` may be empty.
    PatchMesh(const Numbers& points, const Numbers& normals, const Numbers& uv)
        : given_points_(points), given_normals_(normals), given_uv_(uv) {}

    void add(const std::array<std::size_t, 4>& corners) {
        std::array<Imath::V3d, 4> p;
        for (int i = 0; i < 4; ++i)
            p[i] = at(given_points_, corners[i]);
        const double extent = std::max((p[3] - p[0]).length(), (p[2] - p[1]).length());
        const bool bent = (p[0] - p[1] - p[2] + p[3]).length() > kBent * extent;
        const int n = bent ? kSquares : 1;
        const std::size_t first = points_.size() / 3;
        for (int row = 0; row <= n; ++row)
            for (int column = 0; column <= n; ++column)
                add_point(p, corners, double(column) / n, double(row) / n);
        for (int row = 0; row < n; ++row)
            for (int column = 0; column < n; ++column)
                for (const int corner : {0, 1, n + 2, 0, n + 2, n + 1})
                    triangles_.push_back(static_cast<double>(first) + row * (n + 1) + column +
                                         corner);
    }
    void move_to(NewStatement& mesh, const SourceLocation& points_at) {
        mesh.set("integer triindices", std::move(triangles_), &points_at);
        mesh.set("point P", std::move(points_), &points_at);
        mesh.set("normal N", std::move(normals_), &points_at);
        mesh.set("float uv", std::move(uv_), &points_at);
    }

  private:
    static Imath::V3d at(const Numbers& list, std::size_t i) {
        return {list[3 * i], list[3 * i + 1], list[3 * i + 2]};
    }
    static void append(Numbers& list, const Imath::V3d& v) {
        list.insert(list.end(), {v.x, v.y, v.z});
    }
    void add_point(const std::array<Imath::V3d, 4>& p, const std::array<std::size_t, 4>& corners,
                   double u, double v) {
        append(points_, bilinear(p, u, v));
        const auto along_u = (p[1] - p[0]) * (1 - v) + (p[3] - p[2]) * v;
        const auto along_v = (p[2] - p[0]) * (1 - u) + (p[3] - p[1]) * u;
        Imath::V3d normal = along_u % along_v;
        std::array<Imath::V2d, 4> st{{{0, 0}, {1, 0}, {0, 1}, {1, 1}}};
        std::array<Imath::V3d, 4> normals;
        for (int i = 0; i < 4; ++i) {
            if (!given_normals_.empty()) normals[i] = at(given_normals_, corners[i]);
            if (!given_uv_.empty())
                st[i] = {given_uv_[2 * corners[i]], given_uv_[2 * corners[i] + 1]};
        }
        if (!given_normals_.empty()) normal = bilinear(normals, u, v);
        append(normals_, normal.normalized());
        const Imath::V2d place = bilinear(st, u, v);
        uv_.insert(uv_.end(), {place.x, place.y});
    }

    const Numbers &given_points_, &given_normals_, &given_uv_;
    Numbers triangles_, points_, normals_, uv_;
};

Numbers counted(std::size_t count) {
    Numbers numbers(count);
    for (std::size_t i = 0; i < count; ++i)
        numbers[i] = static_cast<double>(i);
    return numbers;
}

}  // namespace

MaterialUse Translator::with_alpha(const MaterialUse& material, const Parameters& p, bool* gone) {
    if (!p.given("alpha")) return material;
    std::string opacity;
    const auto texture = p.texture("alpha");
    double number = 1;
    if (texture) {
        const auto constant = float_constants_.find(texture->text);
        if (constant != float_constants_.end()) number = constant->second;
    } else {
        number = p.number("alpha", 1);
    }
    const bool varies = texture && !float_constants_.contains(texture->text);
    if (!varies && number >= 1) return material;
    *gone = !varies && number <= 0;
    const std::string key =
        material.name + "\n" + (varies ? texture->text : fmt::format("{}", number));
    const auto known = cut_materials_.find(key);
    if (known != cut_materials_.end()) return {known->second, false};
    const SourceLocation& at = p.where("alpha");
    const std::string name = fresh(material.name + "/cut out");
    NewStatement made("MakeNamedMaterial", at);
    made.name(name).set("string type", "mix").set("string namedmaterial1", nothing(at));
    made.set("string namedmaterial2", material.name);
    if (varies)
        made.set("texture amount", float_texture(texture->text));
    else
        made.set("float amount", std::clamp(number, 0.0, 1.0));
    add(std::move(made));
    cut_materials_.emplace(key, name);
    return {name, false};
}

void Translator::shape(Statement& statement) {
    Parameters p = take(statement, "shape");
    const SourceLocation& at = statement.where;
    if (p.plugin() == "curve" && !p.given("alpha") && !state_.area_light) {
        // Hairs of one state are one mesh.
        constexpr std::size_t kMostNumbers = 1'000'000;
        const Curve read = curve(p);
        p.report_unused("shape");
        tell_once(p.where(), kTubes);
        if (curves_.empty()) curves_at_ = at;
        curves_.add(read);
        if (curves_.size() > kMostNumbers) write_curves();
        return;
    }
    MaterialUse material = state_.material ? *state_.material : default_material(at);
    bool gone = false;
    material = with_alpha(material, p, &gone);
    for (const char* known : {"shadowalpha", "discarddegenerateUVs"})
        p.ignore(known);
    std::optional<Emission> emission;
    if (state_.area_light) {
        if (in_object_) {
            tell_once(at, "area lights in objects do not shine, as in pbrt");
        } else {
            emission = area_emission(state_.area_light->where);
            if (gone) emission->statement.set("bool hidden", "true");
        }
    }
    NewStatement made("Shape", at);
    if (!write_shape(made, p)) return;
    if (emission && emission->two_sided) {
        if (is_mesh_)
            made.set("float backs", state_.reverse_orientation ? -kBack : kBack);
        else
            tell_once(at,
                      "of lights with two sides, spheres, disks and cylinders shine on their front "
                      "alone");
    }
    p.report_unused("shape");
    write_placed(std::move(made), material, std::move(emission));
}

void Translator::write_placed(NewStatement made, const MaterialUse& material,
                              std::optional<Emission> emission) {
    const SourceLocation at = made.where();
    // Shapes do not move, but instances of objects do.
    const bool moving = moves() && !in_object_ && !emission;
    const std::string object = moving ? fresh("moving shape") : "";
    if (moving) add(NewStatement("ObjectBegin", at).name(object));
    add("AttributeBegin", at);
    if (!moving) place(at, false, "shape");
    if (state_.reverse_orientation) add("ReverseOrientation", at);
    add(NewStatement("NamedMaterial", at).name(material.name));
    if (!state_.inside.empty()) add(NewStatement("Interior", at).name(state_.inside));
    if (!state_.outside.empty()) add(NewStatement("Exterior", at).name(state_.outside));
    if (emission) add(std::move(emission->statement));
    add(std::move(made));
    add("AttributeEnd", at);
    if (!moving) return;
    add("ObjectEnd", at);
    add("AttributeBegin", at);
    place(at, true, "shape");
    add(NewStatement("ObjectInstance", at).name(object));
    add("AttributeEnd", at);
}

bool Translator::write_shape(NewStatement& made, Parameters& p) {
    const std::string& type = p.plugin();
    const auto number = [&](const char* head, const char* name) {
        if (p.given(name)) made.set(head, p.number(name, 0), &p.where(name));
    };
    is_mesh_ = false;
    if (type == "sphere" || type == "cylinder") {
        made.name(type);
        number("float radius", "radius");
        number("float zmin", "zmin");
        number("float zmax", "zmax");
        number("float phimax", "phimax");
    } else if (type == "disk") {
        made.name(type);
        number("float radius", "radius");
        number("float innerradius", "innerradius");
        number("float height", "height");
        number("float phimax", "phimax");
    } else if (type == "cone" || type == "paraboloid" || type == "hyperboloid") {  // version 3
        made.name(type);
        for (const char* name : {"radius", "height", "zmin", "zmax", "phimax"})
            number(fmt::format("float {}", name).c_str(), name);
        for (const char* name : {"p1", "p2"})
            if (p.given(name)) made.set(fmt::format("point {}", name).c_str(), p.numbers(name));
    } else if (type == "trianglemesh") {
        triangle_mesh(made, p);
    } else if (type == "plymesh") {
        is_mesh_ = true;
        if (p.text("filename", "").empty())
            p.fail("filename", "plymesh needs a file: \"string filename\" \"...\"");
        made.name("plymesh");
        made.set("string filename", p.text("filename", ""), &p.where("filename"));
        made.set("bool usecolor", "false").set("bool facesbynormals", "true");
        p.leave_out("displacement", "the mesh stays as it is");
        p.ignore("displacement.edgelength");
        p.ignore("edgelength");
    } else if (type == "bilinearmesh") {
        bilinear_mesh(made, p);
    } else if (type == "loopsubdiv") {
        loop_subdivision(made, p);
    } else if (type == "curve") {
        is_mesh_ = true;
        tell_once(p.where(), kTubes);
        CurveTubes tubes;
        tubes.add(curve(p));
        tubes.move_to(made);
    } else {
        throw InputError(p.where(),
                         unknown_name_message("shape", type,
                                              {"bilinearmesh", "curve", "cylinder", "disk",
                                               "loopsubdiv", "plymesh", "sphere", "trianglemesh"}));
    }
    return true;
}

void Translator::triangle_mesh(NewStatement& made, Parameters& p) {
    is_mesh_ = true;
    made.name("trianglemesh");
    if (!p.given("P")) p.fail("P", "trianglemesh needs the list \"P\"");
    const SourceLocation points_at = p.where("P");
    Numbers points = p.numbers("P");
    const SourceLocation indices_at = p.where("indices");
    if (p.given("indices"))
        made.set("integer triindices", p.numbers("indices"), &indices_at);
    else if (points.size() == 9)
        made.set("integer triindices", Numbers{0, 1, 2});
    else
        p.fail("indices", "trianglemesh needs the list \"indices\"");
    made.set("point P", std::move(points), &points_at);
    const SourceLocation normals_at = p.where("N");
    if (p.given("N")) made.set("normal N", p.numbers("N"), &normals_at);
    p.rename("st", "uv");
    const SourceLocation uv_at = p.where("uv");
    if (p.given("uv")) made.set("float uv", p.numbers("uv"), &uv_at);
    for (const char* known : {"S", "faceIndices"})
        p.ignore(known);
    made.set("bool facesbynormals", "true");
}

void Translator::bilinear_mesh(NewStatement& made, Parameters& p) {
    is_mesh_ = true;
    made.name("trianglemesh");
    const SourceLocation points_at = p.where("P");
    const Numbers points = p.numbers("P");
    if (points.empty()) p.fail("P", "bilinearmesh needs the list \"P\"");
    Numbers patches = p.numbers("indices");
    if (patches.empty()) patches = counted(points.size() == 12 ? 4 : 0);
    if (patches.size() % 4 != 0 || patches.empty())
        p.fail("indices", "bilinearmesh takes four indices a patch");
    const std::size_t count = points.size() / 3;
    for (const double index : patches)
        if (!(index >= 0 && index < double(count)))
            p.fail("indices", fmt::format("there is no point {:g}, only {}", index, count));
    const auto fitting = [&](const char* name, std::size_t each) {
        Numbers list = p.numbers(name);
        if (list.size() == each * count) return list;
        if (!list.empty())
            p.leave_out(name, fmt::format("it has {} numbers for {} points", list.size(), count));
        return Numbers();
    };
    const Numbers normals = fitting("N", 3), uv = fitting("uv", 2);
    PatchMesh mesh(points, normals, uv);
    for (std::size_t i = 0; i + 3 < patches.size(); i += 4) {
        std::array<std::size_t, 4> corners;
        for (std::size_t k = 0; k < 4; ++k)
            corners[k] = static_cast<std::size_t>(patches[i + k]);
        mesh.add(corners);
    }
    mesh.move_to(made, points_at);
    p.leave_out("emissionfilename", "the light's own colour counts");
    p.ignore("faceIndices");
    made.set("bool facesbynormals", "true");
}

void Translator::loop_subdivision(NewStatement& made, Parameters& p) {
    is_mesh_ = true;
    made.name("loopsubdiv");
    if (!p.given("P") || !p.given("indices"))
        p.fail("P", "loopsubdiv needs the lists \"P\" and \"indices\"");
    const SourceLocation points_at = p.where("P"), indices_at = p.where("indices");
    made.set("integer triindices", p.numbers("indices"), &indices_at);
    made.set("point P", p.numbers("P"), &points_at);
    const int levels = p.integer("levels", p.integer("nlevels", 3));
    made.set("integer nlevels", levels, &p.where("levels"));
    p.ignore("nlevels");
    p.ignore("scheme");
}

Curve Translator::curve(Parameters& p) {
    const std::string type = p.text("type", "flat"), basis = p.text("basis", "bezier");
    Curve curve;
    curve.degree = p.integer("degree", 3);
    if (curve.degree != 2 && curve.degree != 3) p.fail("degree", "a curve's degree is 2 or 3");
    if (basis != "bezier" && basis != "bspline")
        p.fail("basis", unknown_name_message("basis", basis, {"bezier", "bspline"}));
    if (type != "flat" && type != "cylinder" && type != "ribbon")
        p.fail("type", unknown_name_message("type of curve", type, {"flat", "cylinder", "ribbon"}));
    curve.spline = basis == "bspline";
    const Numbers numbers = p.numbers("P");
    for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
        curve.points.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
    if (curve.segments() == 0)
        p.fail("P", fmt::format("a curve of degree {} does not have {} points", curve.degree,
                                curve.points.size()));
    const double both = p.number("width", 1);
    curve.width0 = p.number("width0", both);
    curve.width1 = p.number("width1", both);
    p.ignore("N");
    p.ignore("splitdepth");
    return curve;
}

void Translator::write_curves() {
    if (curves_.empty()) return;
    NewStatement mesh("Shape", curves_at_);
    curves_.move_to(mesh);
    write_placed(std::move(mesh), state_.material ? *state_.material : default_material(curves_at_),
                 std::nullopt);
}

void Translator::object_begin(Statement& statement) {
    const Name name = take_only_name(statement);
    if (in_object_) throw InputError(statement.where, "ObjectBegin inside of an object");
    scopes_.push_back({Scope::Kind::Object, statement.where, state_});
    in_object_ = true;
    add(NewStatement("ObjectBegin", statement.where).name(name.text));
}

void Translator::object_end(Statement& statement) {
    expect_no_arguments(statement);
    if (scopes_.empty() || scopes_.back().kind != Scope::Kind::Object)
        throw InputError(statement.where, "ObjectEnd without ObjectBegin");
    state_ = std::move(scopes_.back().state);
    scopes_.pop_back();
    end_object(statement.where);
}

void Translator::end_object(const SourceLocation& where) {
    in_object_ = false;
    add("ObjectEnd", where);
    for (Statement& statement : std::exchange(put_off_, {}))
        add(std::move(statement));
}

void Translator::object_instance(Statement& statement) {
    const Name name = take_only_name(statement);
    if (in_object_) throw InputError(statement.where, "ObjectInstance inside of an object");
    const SourceLocation& at = statement.where;
    add("AttributeBegin", at);
    place(at, true, "instance");
    add(NewStatement("ObjectInstance", at).name(name.text));
    add("AttributeEnd", at);
}

}  // namespace lxs::pbrt
