// Directives Shape, ObjectBegin, ObjectEnd and ObjectInstance.
#include <fmt/format.h>

#include <algorithm>

#include "translator.h"

namespace lxs::pbrt {
namespace {

/// How far behind its front the back of a lamp that shines on both sides lies, of its extent.
constexpr double kBack = 1e-4;

constexpr const char* kTubes = "curves are tubes of three sides, with smooth normals";

/// A mesh of quadrilaterals as two triangles each; pbrt's corners go 00, 10, 01, 11.
Numbers triangles_of_patches(const Numbers& patches) {
    Numbers triangles;
    triangles.reserve(patches.size() / 4 * 6);
    for (std::size_t i = 0; i + 3 < patches.size(); i += 4)
        for (const std::size_t corner : {0, 1, 3, 0, 3, 2})
            triangles.push_back(patches[i + corner]);
    return triangles;
}

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
    Numbers points = p.numbers("P");
    if (points.empty()) p.fail("P", "bilinearmesh needs the list \"P\"");
    Numbers patches = p.numbers("indices");
    if (patches.empty()) patches = counted(points.size() == 12 ? 4 : 0);
    if (patches.size() % 4 != 0 || patches.empty())
        p.fail("indices", "bilinearmesh takes four indices a patch");
    Numbers uv = p.numbers("uv");
    if (uv.empty() && patches.size() == 4 && points.size() == 12) uv = {0, 0, 1, 0, 0, 1, 1, 1};
    made.set("integer triindices", triangles_of_patches(patches), &p.where("indices"));
    made.set("point P", std::move(points), &points_at);
    if (p.given("N")) made.set("normal N", p.numbers("N"), &p.where("N"));
    if (!uv.empty()) made.set("float uv", std::move(uv), &p.where("uv"));
    p.leave_out("emissionfilename", "the light's own colour counts");
    p.ignore("faceIndices");
    made.set("bool facesbynormals", "true");
    tell_once(p.where(), "patches of \"bilinearmesh\" are two triangles each");
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
