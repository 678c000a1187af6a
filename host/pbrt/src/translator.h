// Turns directives of pbrt into statements of our own language, with pbrt's graphics state.
//
// Conventions
// - Where the film has no sensor of its own, a pixel is the radiance, times the imaging ratio
//   (exposure time by ISO / 100). Lights carry that ratio.
// - Colours of lights and reflectances are written so that the renderer's linear RGB are pbrt's
//   (docs/understand/colours.md).
// - LookAt is left-handed.
// - Faces with normals look where the normals do; those without are flat. Emission is one-sided.
// - v grows upwards in an image of pbrt, downwards in one of LuxRender.
// - Roughness is GGX' alpha, by the root of what the scene gives unless "remaproughness" is false.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "curve_tubes.h"
#include "lxs/language/statement_executor.h"
#include "parameters.h"
#include "spectra.h"

namespace lxs::pbrt {

/// The parameters of one directive, with what directives Attribute had set for it.
using ParameterValues = std::vector<ParameterValue>;

/// Whether pbrt takes an image's values for sRGB unless told otherwise: those of eight bits.
bool is_eight_bit(const std::string& file);

/// A material as shapes refer to it.
struct MaterialUse {
    std::string name;        ///< of our MakeNamedMaterial
    bool interface = false;  ///< only a border of media
};

/// What AttributeBegin keeps.
struct GraphicsState {
    std::array<Matrix, 2> transforms;  ///< when the shutter opens and closes
    unsigned active = 3;               ///< bit i: directives change transform i
    std::optional<MaterialUse> material;
    std::shared_ptr<const ParameterSet> area_light;
    std::string inside, outside;  ///< media; empty: none
    bool reverse_orientation = false;
    const ColourSpace* space = &srgb();
    std::map<std::string, ParameterValues> defaults;  ///< by Attribute's target
};

class Translator {
  public:
    Translator(StatementExecutor& executor, Diagnostics& diagnostics);

    /// Reads a file and what it includes; `more` is added to its last directive. Throws InputError
    /// on bad syntax.
    void read(const std::shared_ptr<const SourceFile>& file, std::vector<Argument> more = {});
    /// After the main file: ends the world.
    void finish();

  private:
    using Method = void (Translator::*)(Statement&);
    enum class Block : std::uint8_t { Anywhere, Options, World };
    struct Rule {
        Method method;
        Block block = Block::Anywhere;
    };
    static const std::map<std::string, Rule>& rules();
    void translate(Statement& statement);
    /// Adds the parameters that a file in the middle of a directive holds; false if it holds none.
    bool join(Statement& include, Statement& before);

    // translator.cpp: blocks, files, state
    void world_begin(Statement& statement);
    void world_end(Statement& statement);
    void include(Statement& statement);
    void import(Statement& statement);
    void attribute_begin(Statement& statement);
    void attribute_end(Statement& statement);
    void transform_begin(Statement& statement);
    void transform_end(Statement& statement);
    void attribute(Statement& statement);
    void option(Statement& statement);
    void colour_space_directive(Statement& statement);
    void reverse_orientation(Statement& statement);
    void nothing(Statement& statement);
    std::shared_ptr<const SourceFile> scene_file(Statement& statement);

    // transform_directives.cpp
    void identity(Statement& statement);
    void translate_directive(Statement& statement);
    void scale(Statement& statement);
    void rotate(Statement& statement);
    void look_at_directive(Statement& statement);
    void transform(Statement& statement);
    void concat_transform(Statement& statement);
    void coordinate_system(Statement& statement);
    void coord_sys_transform(Statement& statement);
    void active_transform(Statement& statement);
    void transform_times(Statement& statement);
    void concatenate(const Matrix& matrix, const SourceLocation& where);
    bool moves() const;
    /// Our Transform, or the motion where the two transforms differ and `may_move`.
    void place(const SourceLocation& where, bool may_move, const char* noun);

    // option_directives.cpp: camera, film and the like
    void camera(Statement& statement);
    void keep_option(Statement& statement);
    struct Options {
        Parameters film, camera, filter, sampler, integrator;
    };
    void write_options(const SourceLocation& where);
    void write_film(Options& options);
    void write_camera(Options& options);
    void write_filter(Parameters& filter);
    void write_integrator(Parameters& integrator);
    /// The parameters of an option, taken; of `plugin` where the scene gives none.
    Parameters option_parameters(const char* directive, const char* plugin,
                                 const SourceLocation& where);

    // material_directives.cpp
    void material(Statement& statement);
    void make_named_material(Statement& statement);
    void named_material(Statement& statement);
    MaterialUse write_material(const std::string& name, Parameters& parameters);
    /// pbrt's material of shapes that name none.
    const MaterialUse& default_material(const SourceLocation& where);
    struct Roughness {
        std::optional<double> u, v;  ///< null: by a texture
        std::string u_texture, v_texture;
        bool smooth() const { return u && v && *u == 0 && *v == 0; }
    };
    Roughness roughness(Parameters& parameters, const std::string& prefix, double fallback);
    void set_roughness(NewStatement& made, const Roughness& roughness, double least) const;
    /// The same for facets as pbrt has them.
    void set_facets(NewStatement& made, const Roughness& roughness) const;
    /// Writes `target` ("Kd") as the colour or texture that `name` gives.
    void set_look(NewStatement& made, const char* target, const Parameters& parameters,
                  std::string_view name, const Rgb& fallback, double factor = 1);
    /// "thickness" of a clear coat.
    double coat_thickness(Parameters& parameters);
    NewStatement coated_diffuse(const std::string& name, Parameters& parameters);
    /// `outside`: the index of what the metal lies in.
    NewStatement conductor(const std::string& name, Parameters& parameters,
                           const std::string& prefix, double outside);
    NewStatement coated_conductor(const std::string& name, Parameters& parameters);
    NewStatement dielectric(const std::string& name, Parameters& parameters);
    NewStatement mix(const std::string& name, Parameters& parameters);
    NewStatement hair(const std::string& name, Parameters& parameters);
    NewStatement subsurface(const std::string& name, Parameters& parameters);
    /// A material of version 3 under its name in version 4.
    void upgrade_material(Parameters& parameters, std::string& type);
    /// Version 3's opacity of "uber": where the material is not, there is nothing.
    void cut_by_opacity(NewStatement& made, const std::string& name, Parameters& parameters);
    /// Our material of what is cut out.
    const std::string& nothing(const SourceLocation& where);
    void set_bump(NewStatement& made, const std::string& name, Parameters& parameters);
    /// An image of numbers, again, as their roots.
    void write_root(const Statement& image, const std::string& name);
    /// An index of refraction: a number, or the mean of a spectrum.
    double index_of(const Parameters& parameters, std::string_view name);

    // texture_directives.cpp
    void texture(Statement& statement);
    void write_texture(const Name& name, bool is_float, Parameters& parameters);
    void image_texture(NewStatement& made, Parameters& parameters, bool is_float);
    /// Program of a texture "nodes": the cosine, >= 0, between the normal and a direction of the
    /// texture's space.
    Strings along_normal(const Vec3& direction) const;
    void set_mapping(NewStatement& made, Parameters& parameters, bool of_image);
    void set_term(NewStatement& made, const char* target, const Parameters& parameters,
                  std::string_view name, bool is_float, double fallback);
    /// The name of a texture of numbers: of `name` itself, or of one that reads the same image as
    /// the texture of colours of that name does (version 3).
    std::string float_texture(const std::string& name);
    /// A name that the scene does not use.
    std::string fresh(const std::string& stem);

    // light_directives.cpp
    void light_source(Statement& statement);
    void area_light_source(Statement& statement);
    /// Colour and gain of a light whose colour is `name`.
    void set_emission(NewStatement& made, const Parameters& parameters, std::string_view name,
                      double scale);
    void infinite_light(NewStatement& made, Parameters& parameters, double scale,
                        double illuminance);
    struct Emission {
        NewStatement statement;
        bool two_sided = false;
    };
    /// What shapes at `where` shine with.
    Emission area_emission(const SourceLocation& where);

    // shape_directives.cpp
    void shape(Statement& statement);
    void object_begin(Statement& statement);
    void object_end(Statement& statement);
    void end_object(const SourceLocation& where);
    void object_instance(Statement& statement);
    /// Writes the shape; false if it is left out.
    bool write_shape(NewStatement& made, Parameters& parameters);
    void triangle_mesh(NewStatement& made, Parameters& parameters);
    void bilinear_mesh(NewStatement& made, Parameters& parameters);
    void loop_subdivision(NewStatement& made, Parameters& parameters);
    Curve curve(Parameters& parameters);
    /// The curves that wait, as a shape of the state in force.
    void write_curves();
    /// Puts a shape into the world.
    void write_placed(NewStatement made, const MaterialUse& material,
                      std::optional<Emission> emission);
    MaterialUse with_alpha(const MaterialUse& material, const Parameters& parameters, bool* gone);

    // medium_directives.cpp
    void make_named_medium(Statement& statement);
    struct Coefficients {
        Rgb absorption, scattering;
    };
    Coefficients coefficients(const Parameters& p);
    Rgb emission_of_medium(Parameters& p, const std::string& type);
    /// A texture that is 1 where the density is `most`.
    struct Density {
        std::string texture;
        float most = 0;
    };
    Density density_grid(Parameters& p, const std::string& medium);
    Density cloud(const Parameters& p, const std::string& medium);
    Density filed_density(const Parameters& p, const std::string& medium);
    std::string colour_grid(Parameters& p, const char* name, const std::string& medium,
                            float scale);
    static Bounds medium_box(const Parameters& p);
    static void set_cells(NewStatement& made, const Parameters& p);
    void add_in_medium(NewStatement texture, const SourceLocation& at, Numbers matrix);
    void medium_interface(Statement& statement);

    void add(Statement statement) {
        if (is_put_off_)
            put_off_.push_back(std::move(statement));
        else
            executor_.add(std::move(statement));
    }
    void add(NewStatement statement) { add(statement.take()); }
    void add(const char* word, const SourceLocation& where) { add(Statement{word, where, {}}); }
    void warn(const SourceLocation& where, const std::string& message) {
        diagnostics_.warning(where, message);
    }
    /// Once a scene, at its first place.
    void tell_once(const SourceLocation& where, const std::string& message) {
        if (!std::exchange(told_[message], true)) warn(where, message);
    }
    Parameters take(Statement& statement, const char* target);
    const ParameterValues& defaults(const char* target) const;

    StatementExecutor& executor_;
    Diagnostics& diagnostics_;
    SpectrumReader spectra_;
    GraphicsState state_;
    struct Scope {
        enum class Kind : std::uint8_t { Attribute, Transform, Object } kind;
        SourceLocation where;
        GraphicsState state;
    };
    std::vector<Scope> scopes_;
    std::map<std::string, std::array<Matrix, 2>> coordinate_systems_;
    std::map<std::string, Statement> options_;  ///< by directive, until WorldBegin
    std::map<std::string, MaterialUse> named_materials_;
    std::map<std::string, std::string> cut_materials_;  ///< by material and opacity
    std::map<std::string, double> float_constants_;     ///< textures of one number
    std::map<std::string, Statement> float_images_;     ///< textures of numbers, as written
    std::map<std::string, Statement> colour_images_;    ///< textures of colours, as written
    std::set<std::string> float_textures_;              ///< names of all textures of numbers
    std::set<std::string> float_roots_;                 ///< those that write_root() has written
    std::map<std::string, int> names_;                  ///< made by fresh()
    std::optional<MaterialUse> default_material_;
    CurveTubes curves_;  ///< of the state in force, until another directive comes
    SourceLocation curves_at_;
    std::string nothing_;  ///< our material of what is cut out
    std::array<Matrix, 2> camera_transforms_;
    std::array<double, 2> times_{0, 1};
    std::string camera_medium_;
    SourceLocation last_;
    double imaging_ratio_ = 1;
    bool in_world_ = false, ended_ = false, in_object_ = false;
    bool version_3_ = false;          ///< some word told so
    std::vector<Statement> put_off_;  ///< until the object ends
    bool is_put_off_ = false;         ///< what is added now
    bool is_mesh_ = false;            ///< what write_shape() wrote last
    bool area_light_told_ = false;    ///< of its unknown parameters
    bool version_3_words_ = false;    ///< the material's name is of version 3
    bool awaits_active_transform_ = false;
    std::map<std::string, bool> told_;  ///< what is said once a scene
};

}  // namespace lxs::pbrt
