// Interprets the statements of a scene: what each means for the graphics state and the contents.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "included_files.h"
#include "lxs/language/read_files.h"
#include "lxs/language/statement.h"
#include "lxs/scene/contents.h"
#include "lxs/scene/registry.h"
#include "named_assets.h"
#include "object_library.h"
#include "plugin_factory.h"
#include "scope_stack.h"

namespace lxs {

class SceneReader {
  public:
    /// `directory`: where file names in the scene are looked up.
    SceneReader(const std::string& directory, const Registry& registry, Diagnostics& diagnostics);

    /// Reads a file and what it includes. Throws InputError on bad syntax.
    void read(const std::shared_ptr<const SourceFile>& file);
    /// Carries out these statements in order, when their files have been read ahead.
    void execute_all(std::vector<Statement> statements);
    /// Runs `action`, and reports its error; throws EndOfReading after very many.
    void guard(const std::function<void()>& action);
    /// The file that an Include names. Throws as open_include() does.
    std::shared_ptr<const SourceFile> open(const Name& file);
    void opened(const std::shared_ptr<const SourceFile>& file) { files_.sources.push_back(file); }
    /// Path of a file that the scene names. Throws InputError.
    std::string find(const Name& file) { return finder_.find(file.text, file.where, diagnostics_); }
    /// The same without messages; empty if there is none.
    std::string find_quietly(const Name& file);
    /// All files read so far; forgets them.
    ReadFiles take_files() { return std::exchange(files_, {}); }
    /// The scene, after the main file; that it has no world, or no end, is an error.
    SceneContents finish();

  private:
    /// Where a statement may stand.
    enum class Block : std::uint8_t { Anywhere, BeforeWorld, World };
    using Method = void (SceneReader::*)(Statement&);
    struct Rule {
        Method method;
        Block block = Block::Anywhere;
        bool in_motion = false;  ///< also between MotionBegin and MotionEnd
    };
    static const std::map<std::string, Rule>& rules();
    /// Reports errors and goes on behind the statement; throws EndOfReading after very many.
    void execute(Statement& statement);
    void interpret(Statement& statement);
    void check_place(const Statement& statement, const Rule& rule) const;

    // scene_reader.cpp: blocks and files
    void world_begin(Statement& statement);
    void world_end(Statement& statement);
    void close_world(const SourceLocation& where);
    void include(Statement& statement);
    void search_path(Statement& statement);

    // option_statements.cpp
    void option(Statement& statement);

    // transform_statements.cpp
    void identity(Statement& statement);
    void translate(Statement& statement);
    void scale(Statement& statement);
    void rotate(Statement& statement);
    void look_at_statement(Statement& statement);
    void transform(Statement& statement);
    void concat_transform(Statement& statement);
    void coordinate_system(Statement& statement);
    void coord_sys_transform(Statement& statement);
    void transform_begin(Statement& statement);
    void transform_end(Statement& statement);
    void motion_begin(Statement& statement);
    void motion_end(Statement& statement);
    /// Sets the current transform; between MotionBegin and MotionEnd, the next key's.
    void set_transform(const Matrix& matrix, const SourceLocation& where);
    void concatenate(const Matrix& matrix, const SourceLocation& where);
    /// Throws InputError for an unknown name.
    const Matrix& coordinate_system_of(const Name& name);
    void add_motion_key(const Matrix& matrix, const SourceLocation& where);
    MovingTransform current_transform() const { return {scopes_.transform, scopes_.motion}; }
    /// Where shapes and lights stand, which do not move; a moving transform is warned of.
    const Matrix& still_transform(const char* noun, const SourceLocation& where);

    // world_statements.cpp
    void attribute_begin(Statement& statement);
    void attribute_end(Statement& statement);
    void reverse_orientation(Statement& statement);
    void texture(Statement& statement);
    void material(Statement& statement);
    void make_named_material(Statement& statement);
    void named_material(Statement& statement);
    void make_named_volume(Statement& statement);
    void interior(Statement& statement);
    void exterior(Statement& statement);
    void volume_region(Statement& statement);
    void light_group(Statement& statement);
    void light_source(Statement& statement);
    void area_light_source(Statement& statement);
    void shape(Statement& statement);
    void portal_shape(Statement& statement);
    void portal_instance(Statement& statement);
    void object_begin(Statement& statement);
    void object_end(Statement& statement);
    void object_instance(Statement& statement);
    void motion_instance(Statement& statement);

    IndexedMaterial add_material(const ParameterSet& set, std::string name);
    const IndexedMaterial& default_material();
    std::uint32_t group_index(const std::string& name);
    Inheritance inheritance() const;
    void warn_redefined(bool is_new, const char* noun, const Name& name);

    /// Between MotionBegin and MotionEnd.
    struct MotionBlock {
        SourceLocation where;
        std::vector<double> times;
        Motion keys;           ///< so far
        MovingTransform base;  ///< the transform at MotionBegin
    };

    ReadFiles files_;
    Diagnostics& diagnostics_;
    AssetFinder finder_;
    UnknownNames unknown_;
    FilesAhead ahead_;
    NamedAssets assets_;
    PluginFactory factory_;
    ObjectLibrary objects_;
    ScopeStack scopes_;
    std::map<std::string, Matrix> coordinate_systems_;
    std::map<std::string, std::uint32_t> group_indices_;
    IndexedMaterial default_material_;
    std::optional<MotionBlock> motion_;
    IncludedSum included_;
    SceneContents contents_;
    SourceLocation last_statement_;
    std::size_t errors_ = 0;
    bool in_world_ = false;
    bool ended_ = false;
};

}  // namespace lxs
