// The state of parse(): one function a directive.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "scene_io/pbrt/directives.h"
#include "scene_io/pbrt/graphics_state.h"
#include "scene_io/pbrt/program.h"
#include "scene_io/pbrt/source_files.h"

namespace candela::pbrt {

class Parser {
 public:
  Parser(SourceFiles& files, const Report& report) : files_(files), report_(report) {}

  Program parse();

  // The directives. Each reads what follows its name.
  void accelerator();
  void active_transform();
  void area_light_source();
  void attribute();
  void attribute_begin();
  void attribute_end();
  void camera();
  void color_space();
  void concat_transform();
  void coordinate_system();
  void coord_sys_transform();
  void film();
  void identity();
  void import();
  void include();
  void integrator();
  void light_source();
  void look_at();
  void make_named_material();
  void make_named_medium();
  void material();
  void medium_interface();
  void named_material();
  void object_begin();
  void object_end();
  void object_instance();
  void option();
  void pixel_filter();
  void reverse_orientation();
  void rotate();
  void sampler();
  void scale();
  void shape();
  void texture();
  void transform();
  void transform_times();
  void translate();
  void world_begin();
  void world_end();

 private:
  struct Block {
    GraphicsState state;
    Place place;
    enum class Kind : std::uint8_t { Attribute, Object, Import } kind = Kind::Attribute;
    std::string_view directive;  // that began it
  };

  void statement(const Token& directive);
  const Directive* known_directive();
  void check_side_of_world(const Directive& directive);
  void skip_to_directive();
  void end_file();

  void error(std::size_t offset, std::string message) const;
  void error_here(std::string message) const { error(directive_.offset, std::move(message)); }
  void warn_once(const std::string& key, const Place& place, std::string message);
  [[nodiscard]] Place here() const { return {file_, directive_.offset}; }

  // What stands behind a directive's name. Nothing after an error.
  std::optional<std::string> read_string(std::string_view what);
  template <std::size_t n>
  std::optional<std::array<double, n>> read_numbers();
  std::optional<double> read_number();
  // `place`: of what it is the value of.
  std::optional<Token> read_value(std::string_view what, const Place& place);
  ParameterList read_list();
  // A type and parameters: Shape "sphere" "float radius" 2.
  std::optional<Statement> read_statement(std::optional<AttributeTarget> target = std::nullopt);
  // Of several statements of one directive the last counts.
  void keep(std::optional<Statement> statement, std::optional<Statement>& kept);
  void apply(const Transform& transform);
  void set_seed(const Token& value);

  bool push(Block::Kind kind);
  bool pop(Block::Kind kind);
  [[nodiscard]] bool is_in_object() const { return object_ != nullptr; }
  void include_file(bool is_import);
  void add_defaults(Statement& statement, AttributeTarget target);
  MaterialUse add_material(std::string name, Statement statement);

  SourceFiles& files_;
  const Report& report_;
  Program program_;
  GraphicsState state_;
  std::vector<Block> blocks_;
  std::map<std::string, Transform> systems_;
  std::set<std::string> warned_;
  std::deque<ShapeStatement>* object_ = nullptr;  // being defined
  std::size_t nested_objects_ = 0;                // within it, each in error
  bool is_in_world_ = false;
  bool lacks_world_ = false;       // said: something stands before WorldBegin
  std::size_t default_bytes_ = 0;  // that statements have from Attribute

  // Of the directive being read.
  const SourceFile* file_ = nullptr;
  Tokenizer* tokens_ = nullptr;
  Token directive_;
};

}  // namespace candela::pbrt
