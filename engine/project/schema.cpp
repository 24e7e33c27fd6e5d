// The schema of .kfa files: an archive that is told of every field and writes down what it may be.

#include <array>
#include <string>

#include "engine/project/fields/project_fields.h"
#include "engine/project/json/field_writer.h"
#include "engine/project/json/json.h"
#include "engine/project/project_reader.h"

namespace hazumi {

namespace {

// What no description tells: how lists of numbers become text, and what a figure is.
constexpr const char* kBytes = R"({"type": "string", "pattern": "^[A-Za-z0-9+/]*={0,2}$"})";
constexpr const char* kFigure = R"({
  "oneOf": [
    {
      "type": "object",
      "required": ["file"],
      "properties": {"file": {"type": "string", "minLength": 1}},
      "not": {"required": ["format"]}
    },
    {"$ref": "figure.schema.json"}
  ]
})";
constexpr const char* kJointRef = R"({
  "oneOf": [
    {
      "description": "The joint; with + behind its name everything beyond it, too.",
      "type": "string",
      "minLength": 1
    },
    {
      "description": "The joint and everything beyond it; of the root, the whole figure.",
      "type": "object",
      "required": ["beyond"],
      "properties": {"beyond": {"type": "string", "minLength": 1}}
    }
  ]
})";
constexpr const char* kSkin = R"({
  "oneOf": [
    {
      "description": "A skin that comes with Hazumi.",
      "type": "object",
      "required": ["shipped"],
      "properties": {"shipped": {"enum": ["human"]}}
    },
    {"$ref": "#/definitions/skin"}
  ]
})";
constexpr const char* kOwnSkin = R"({
  "description": "A mesh that follows the figure's bodies, drawn only. A vertex v is the sum over its four binds of weight * X_WB * inverse_bind * v. Lists of numbers are base64 of their little-endian bytes.",
  "type": "object",
  "required": ["bones", "meshes"],
  "properties": {
    "bones": {
      "description": "Joints, or the root, by name; counted by a bind's bone.",
      "type": "array",
      "items": {
        "oneOf": [
          {"type": "string"},
          {
            "description": "A joint whose angles, or a hinge whose angle, are taken times the share.",
            "type": "object",
            "required": ["joint", "share"],
            "properties": {
              "joint": {"type": "string"},
              "share": {"type": "number", "minimum": 0, "maximum": 1}
            }
          }
        ]
      }
    },
    "meshes": {"type": "array", "items": {"$ref": "#/definitions/skin_mesh"}},
    "materials": {
      "type": "array",
      "items": {
        "type": "object",
        "required": ["name", "base_color", "texture"],
        "properties": {
          "name": {"type": "string"},
          "base_color": {
            "description": "Linear red, green, blue and alpha.",
            "type": "array",
            "items": {"type": "number"},
            "minItems": 4,
            "maxItems": 4
          },
          "texture": {"type": "integer", "minimum": -1, "description": "-1: none."},
          "emission": {
            "description": "Linear red, green and blue that are seen without light.",
            "type": "array",
            "items": {"type": "number"},
            "minItems": 3,
            "maxItems": 3
          },
          "emission_texture": {"type": "integer", "minimum": -1, "description": "A factor of emission; -1: none."}
        }
      }
    },
    "textures": {
      "type": "array",
      "items": {
        "type": "object",
        "required": ["name", "image"],
        "properties": {
          "name": {"type": "string"},
          "image": {"$ref": "#/definitions/bytes", "description": "A PNG or JPEG file."}
        }
      }
    }
  }
})";
constexpr const char* kSkinMesh = R"({
  "type": "object",
  "required": ["name", "material", "binds", "positions", "normals", "texture_coordinates", "bind_indices", "weights", "triangles"],
  "properties": {
    "name": {"type": "string"},
    "material": {"type": "integer", "minimum": -1, "description": "-1: none."},
    "binds": {
      "type": "array",
      "items": {
        "type": "object",
        "required": ["bone", "inverse_bind"],
        "properties": {
          "bone": {"type": "integer", "minimum": 0},
          "inverse_bind": {
            "description": "From the mesh to the bone's body [m], the upper three rows.",
            "type": "array",
            "items": {"type": "number"},
            "minItems": 12,
            "maxItems": 12
          }
        }
      }
    },
    "positions": {"$ref": "#/definitions/bytes", "description": "3 floats a vertex."},
    "normals": {"$ref": "#/definitions/bytes", "description": "3 floats a vertex."},
    "texture_coordinates": {"$ref": "#/definitions/bytes", "description": "2 floats a vertex, v downwards, or empty."},
    "colors": {"$ref": "#/definitions/bytes", "description": "3 floats a vertex, linear red, green and blue: a factor of the material's colour."},
    "bind_indices": {"$ref": "#/definitions/bytes", "description": "4 16-bit numbers a vertex."},
    "weights": {"$ref": "#/definitions/bytes", "description": "4 floats a vertex, whose sum is 1."},
    "triangles": {"$ref": "#/definitions/bytes", "description": "3 32-bit numbers each."}
  }
})";

// Of the definitions that structs have by name.
class Definitions {
 public:
  Definitions() : all_(Json::object()) {
    all_["bytes"] = FromText(kBytes);
    all_["skin"] = FromText(kOwnSkin);
    all_["skin_mesh"] = FromText(kSkinMesh);
  }

  // Of a struct: a reference to its definition, or if it has no name what it is.
  template <typename T>
  Json Of(const T& value);

  Json TakeAll() { return std::move(all_); }

 private:
  Json all_;
};

// A help that stands in a sentence of its own.
std::string Sentence(std::string clause) {
  if (clause.empty()) return clause;
  clause[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(clause[0])));
  return clause + (clause.ends_with('.') ? "" : ".");
}

std::string DescriptionOf(const Field& field) {
  std::string text = field.help;
  if (field.unit[0] != '\0') text += (text.empty() ? "[" : " [") + std::string(field.unit) + "]";
  text = Sentence(std::move(text));
  if (field.details[0] != '\0') text += (text.empty() ? "" : " ") + std::string(field.details);
  return text;
}

class SchemaWriter {
 public:
  template <typename T>
  using RefTo = const T&;

  explicit SchemaWriter(Definitions* definitions) : definitions_(definitions) {}

  template <typename T>
  void Required(const Field& field, const T& value) {
    required_.push_back(field.name);
    Stated(field, value);
  }
  template <typename T>
  void Stated(const Field& field, const T& value) {
    Put(field, SchemaOf(field, value));
  }
  template <typename T>
  void Optional(const Field& field, const T& value, const T& otherwise = T()) {
    Stated(field, value);
    if constexpr (std::is_arithmetic_v<T> || FileEnum<T>) {
      properties_[field.name]["default"] = ToJson(otherwise);
    }
  }
  template <typename T>
  void Literal(const char* name, const T& value) {
    required_.push_back(name);
    properties_[name] = {{"const", ToJson(value)}};
  }
  void Version(int) {
    required_.push_back("version");
    Json versions = Json::array();
    for (int version = 1; version <= kNewestFormat; ++version) versions.push_back(version);
    properties_["version"] = {{"enum", std::move(versions)}};
  }
  template <typename... T>
  void OneOf(const std::array<const char*, sizeof...(T)>& names, const std::variant<T...>&) {
    size_t i = 0;
    (Stated({names[i++]}, T()), ...);
    for (const char* name : names) one_of_.push_back({{"required", {name}}});
  }
  template <typename T, typename Fields>
  void Nested(const Field& field, const T& value, Fields fields) {
    Put(field, ObjectOf(value, fields));
  }
  template <typename T, typename Fields>
  void List(const Field& field, const std::vector<T>& values, Fields fields) {
    required_.push_back(field.name);
    OptionalList(field, values, fields);
  }
  template <typename T, typename Fields>
  void OptionalList(const Field& field, const std::vector<T>&, Fields fields) {
    Put(field, {{"type", "array"}, {"items", ObjectOf(T(), fields)}});
  }
  template <typename T, typename Fields>
  void Map(const Field& field, const std::vector<Named<T>>&, Fields fields) {
    Put(field, {{"type", "object"}, {"additionalProperties", ObjectOf(T(), fields)}});
  }

  // A property whose value is known.
  void Settle(const char* name, const std::string& value) {
    properties_[name] = {{"const", value}};
  }

  Json TakeObject() {
    Json object = {{"type", "object"}};
    if (!required_.empty()) object["required"] = std::move(required_);
    object["properties"] = std::move(properties_);
    if (!one_of_.empty()) object["oneOf"] = std::move(one_of_);
    return object;
  }

 private:
  void Put(const Field& field, Json schema) {
    const std::string description = DescriptionOf(field);
    if (!description.empty()) schema["description"] = description;
    properties_[field.name] = std::move(schema);
  }

  template <typename T, typename Fields>
  Json ObjectOf(const T& value, Fields fields) {
    SchemaWriter object(definitions_);
    fields(object, value);
    return object.TakeObject();
  }

  static Json NumberOf(const char* type, const NumberRange& range) {
    Json schema = {{"type", type}};
    if (range.lower > -kLargestNumber) {
      schema[range.is_above ? "exclusiveMinimum" : "minimum"] = range.lower;
    }
    if (range.upper < kLargestNumber) schema["maximum"] = range.upper;
    return schema;
  }

  Json SchemaOf(const Field& field, double) { return NumberOf("number", field.range); }
  Json SchemaOf(const Field& field, int) { return NumberOf("integer", field.range); }
  Json SchemaOf(const Field&, bool) { return {{"type", "boolean"}}; }
  template <FileEnum Enum>
  Json SchemaOf(const Field&, Enum) {
    Json words = Json::array();
    for (const auto& entry : EnumNames<Enum>::kNames) words.push_back(entry.name);
    return {{"enum", std::move(words)}};
  }
  Json SchemaOf(const Field& field, const std::string&) {
    Json schema = {{"type", "string"}};
    if (field.is_filled) schema["minLength"] = 1;
    if (field.thing == Thing::kColor) schema["pattern"] = "^#[0-9a-fA-F]{6}$";
    return schema;
  }
  Json SchemaOf(const Field& field, const Vec3&) {
    return {{"type", "array"},
            {"items", NumberOf("number", field.range)},
            {"minItems", 3},
            {"maxItems", 3}};
  }
  Json SchemaOf(const Field&, const std::vector<JointRef>&) {
    return {{"type", "array"}, {"items", FromText(kJointRef)}, {"minItems", 1}};
  }
  Json SchemaOf(const Field& field, const std::vector<Named<double>>&) {
    return {{"type", "object"}, {"additionalProperties", NumberOf("number", field.range)}};
  }
  Json SchemaOf(const Field&, const ProjectFigure&) { return FromText(kFigure); }
  Json SchemaOf(const Field&, const ProjectSkin&) { return FromText(kSkin); }
  Json SchemaOf(const Field&, const ProjectMesh&) { return {{"$ref", "#/definitions/skin"}}; }
  template <typename T>
  Json SchemaOf(const Field& field, const std::optional<T>&) {
    return SchemaOf(field, T());
  }
  template <typename T>
  Json SchemaOf(const Field&, const std::vector<T>&) {
    return {{"type", "array"}, {"items", definitions_->Of(T())}};
  }
  template <typename T>
  requires std::is_class_v<T> Json SchemaOf(const Field&, const T& value) {
    return definitions_->Of(value);
  }

  Definitions* definitions_;
  Json properties_ = Json::object(), required_ = Json::array(), one_of_ = Json::array();
};

// One object for each kind, with the fields that it has.
template <HasKind T>
Json ObjectsOfKinds(Definitions* definitions) {
  Json kinds = Json::array();
  ForEachKind<T>([&](const T& item, const char* kind) {
    SchemaWriter writer(definitions);
    Describe(writer, item);
    writer.Settle("kind", kind);
    kinds.push_back(writer.TakeObject());
  });
  return {{"oneOf", std::move(kinds)}};
}

template <typename T>
Json ObjectOf(const T& value, Definitions* definitions) {
  if constexpr (HasKind<T>) return ObjectsOfKinds<T>(definitions);
  SchemaWriter writer(definitions);
  Describe(writer, value);
  return writer.TakeObject();
}

template <typename T>
Json DescribedObject(const T& value, Definitions* definitions) {
  Json object = ObjectOf(value, definitions);
  if (kStructInfo<T>.text[0] != '\0') object["description"] = kStructInfo<T>.text;
  return object;
}

template <typename T>
Json Definitions::Of(const T& value) {
  if (kStructInfo<T>.name[0] == '\0') return DescribedObject(value, this);
  if (!all_.contains(kStructInfo<T>.name)) {
    all_[kStructInfo<T>.name] = DescribedObject(value, this);
  }
  return {{"$ref", std::string("#/definitions/") + kStructInfo<T>.name}};
}

}  // namespace

std::string ProjectSchema() {
  Definitions definitions;
  Json schema = {{"$schema", "http://json-schema.org/draft-07/schema#"},
                 {"title", "Hazumi project (.kfa), format versions 1 and 2"}};
  schema.update(DescribedObject(Project(), &definitions));
  schema["definitions"] = definitions.TakeAll();
  return FormatJson(schema);
}

}  // namespace hazumi
