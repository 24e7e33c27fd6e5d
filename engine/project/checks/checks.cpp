#include "engine/project/checks/checks.h"

#include <algorithm>
#include <charconv>
#include <iterator>

namespace hazumi {

namespace {

constexpr ErrorCode kSyntax = ErrorCode::kSyntax;
constexpr ErrorCode kSchema = ErrorCode::kSchema;
constexpr ErrorCode kSemantics = ErrorCode::kSemantics;
constexpr ErrorCode kNoInput = ErrorCode::kNoInput;
constexpr ErrorCode kCannotWrite = ErrorCode::kCannotWrite;

constexpr CheckText kTexts[] = {
    {Check::kCannotRead, kNoInput, "cannot be read: {}"},
    {Check::kNotAFile, kNoInput, "is not a file"},
    {Check::kFileTooBig, kSchema, "is larger than 160 MiB, the most that Hazumi reads"},
    {Check::kNotUtf8, kSyntax, "not UTF-8 text; save the file as UTF-8"},
    {Check::kNotJson, kSyntax, "not JSON: {}"},
    {Check::kNumberOverflow, kSchema, "the number {} is out of range"},
    {Check::kTooDeep, kSchema, "more than 64 objects and arrays inside each other"},
    {Check::kTooManyValues, kSchema, "its values would need more than {} MB of memory"},
    {Check::kFieldTwice, kSchema, "the field {} is given twice; keep one of them"},

    {Check::kNotAProject, kSchema,
     "not a Hazumi project: expected an object with \"format\": \"hazumi-project\""},
    {Check::kNotAFigure, kSchema,
     "not a Hazumi figure: expected an object with \"format\": \"hazumi-figure\""},
    {Check::kNotPoses, kSchema,
     "not a file of Hazumi poses: expected an object with \"format\": \"hazumi-poses\""},
    {Check::kNotASweep, kSchema,
     "not a Hazumi sweep: expected an object with \"format\": \"hazumi-sweep\""},
    {Check::kNewerFormat, kSchema,
     "made by a newer Hazumi: this is format version {}, this Hazumi reads {}; please update it"},
    {Check::kUnknownFormat, kSchema, "there is no format version {}; write 1"},
    {Check::kMissingField, kSchema, "the field {} is missing; add it"},
    {Check::kMisspelledField, kSchema, "the field {} is missing; did you mean it by {}?"},
    {Check::kWrongType, kSchema, "expected {}, found {}"},
    {Check::kNumberTooLarge, kSchema, "{} is too large: numbers lie between -1e9 and 1e9"},
    {Check::kNotWhole, kSchema, "expected a whole number, found {}"},
    {Check::kWrongCount, kSchema, "expected {} values, found {}"},
    {Check::kUnknownChoice, kSchema, "there is no {}; {}"},
    {Check::kNotOneOf, kSchema, "needs exactly one of {}"},
    {Check::kBadColor, kSchema,
     "{} is no colour; write it as \"#rrggbb\", for example \"#d9482b\""},
    {Check::kNotFinite, kSchema, "must be a finite number"},
    {Check::kNotPositive, kSchema, "must be greater than 0, is {}"},
    {Check::kNegative, kSchema, "must not be negative, is {}"},
    {Check::kRange, kSchema, "must lie between {} and {}, is {}"},
    {Check::kZeroVector, kSchema, "must not be zero: it gives a direction"},
    {Check::kNotUnit, kSchema, "must have length 1, has {}; write {}"},
    {Check::kEmptyName, kSchema, "must not be empty"},

    {Check::kUnknownParent, kSchema, "no joint {} to hang on; {}"},
    {Check::kTooManyJoints, kSchema, "{} joints; a figure has 10000 at most"},
    {Check::kFigureUnreadable, kNoInput,
     "the figure {} {}; looked for as {}; paths are relative to the project file"},

    {Check::kNotBytes, kSchema, "must be base64 of whole entries"},
    {Check::kBadMesh, kSchema, "does not fit together: {}"},
    {Check::kBadFrameRate, kSchema, "must lie between 0.1 and 10000 frames a second, is {}/{}"},
    {Check::kFramesReversed, kSchema, "the last frame {} is before the first, {}"},
    {Check::kTooManyFrames, kSchema, "{} frames; a project has 1000000 at most"},
    {Check::kNewerSolver, kSchema,
     "made for version {} of the solver, this Hazumi has {}; please update it"},
    {Check::kKeyOrder, kSchema, "frame {} comes after frame {}; write keys in order of frames"},
    {Check::kKeyTwice, kSchema, "a second key on frame {}; keep one of them"},
    {Check::kSpanEmpty, kSchema, "first_frame {} must be before last_frame {}"},
    {Check::kRegionEmpty, kSchema, "a region needs at least one joint"},
    {Check::kDriveEmpty, kSchema, "a drive needs at least one joint"},
    {Check::kSetEmpty, kSchema, "a selection set needs at least one joint"},
    {Check::kFillEmpty, kSchema, "a fill needs at least one joint"},
    {Check::kFillsOverlap, kSchema,
     "{} fills {} in frames {} to {}, too; end one where the other begins, or take the joint out "
     "of "
     "one"},
    {Check::kGoalEmpty, kSchema, "a goal of kind pose needs at least one joint"},
    {Check::kNameTwice, kSchema, "the name {} is already used by {}; choose another"},
    {Check::kNoView, kSchema, "eye_m and target_m are the same point; move one of them"},
    {Check::kReleaseByNobody, kSchema,
     "nobody has it at first who could let go; give it a joint or remove this"},
    {Check::kHoldersOverlap, kSchema,
     "begins in frame {}, when {} still has it; end that one before or in that frame"},
    {Check::kPositionIncomplete, kSchema,
     "has no keys, but others of x, y and z have; give keys to all three or to none"},

    {Check::kUnknownJoint, kSchema, "no joint {}; {}"},
    {Check::kKeysOnGroup, kSchema, "{} has {} hinges; key each by its name: {}"},
    {Check::kRootInRegion, kSchema,
     "{} is the root, which method \"paper\" leaves to its keys; choose method \"exact\" for this "
     "region, or name joints beyond the root"},
    {Check::kRootNotAJoint, kSchema,
     "{} is the root, not a joint; name a joint (the root's own keys stand under \"root\")"},
    {Check::kFrictionOnRoot, kSchema,
     "{} is the root: friction acts in joints, and the root has none; remove it"},
    {Check::kFrictionNotInRegion, kSchema,
     "{} is not in this region; add it to the region's joints or remove its friction"},
    {Check::kDriveOnRoot, kSchema,
     "{} is the root: muscles act in joints, and the root has none; remove it, or put + behind its "
     "name for all joints of the region"},
    {Check::kDriveNotInRegion, kSchema,
     "{} is not in this region; add it to the region's joints or take it out of the drive"},
    {Check::kDrivenTwice, kSchema, "{} has {} already; a joint has one drive"},
    {Check::kUnknownObject, kSchema, "no object {}, neither in the scene nor held; {}"},
    {Check::kAmbiguousObject, kSchema,
     "the scene and what is held both have {}; give one of them another name"},
    {Check::kJointAndObject, kSchema, "is fixed to {} and to {}; keep one of them"},

    {Check::kOutsideFrames, kSemantics,
     "frames {} to {} are not within the project's frames {} to {}; move them or lengthen the "
     "project"},
    {Check::kReleaseOutside, kSemantics, "frame {} is not within the project's frames {} to {}"},
    {Check::kPlacedByNobody, kSemantics,
     "nobody has {} in frame {}, and it has no position; give it a joint or keys of its position"},
    {Check::kDriveFrozen, kSemantics,
     "{} has friction 0, which keeps it still; raise its friction or take it out of the drive"},
    {Check::kDriveSplitsBall, kSemantics,
     "{} is one of the three hinges of {}, which share a spring; drive all three"},
    {Check::kDriveWithoutStrength, kSemantics,
     "the figure does not say how strong {} is; give the drive a max_torque_n_m in place of "
     "strength, or the figure's hinges a strength"},
    {Check::kDriveCurveOutside, kSemantics,
     "between its keys the curve reaches {} at frame {}, and must stay from {} to {}; give keys "
     "beside that a rate, or interpolation linear"},
    {Check::kRegionsOverlap, kSemantics,
     "regions {} and {} both drive {} in frames {} to {}; end one where the other begins, or take "
     "it out of one"},
    {Check::kMethodsDiffer, kSemantics,
     "regions {} and {} share frames {} to {}, but one has method {} and the other {}; give them "
     "the same, or end one where the other begins"},
    {Check::kMethodInGravity, kSemantics,
     "region {} has method {}, but in frames {} to {} gravity places the figure ({}) by the "
     "solver's method {}; leave out the region's, or end one where the other begins"},
    {Check::kRegionAllFixed, kSemantics,
     "every joint of region {} is fixed by equal limits, so nothing can swing; name others"},
    {Check::kPlacementsOverlap, kSemantics,
     "overlaps placements[{}] in frames {} to {}; end one where the other begins"},
    {Check::kNothingToSolve, kSemantics,
     "no joint lies between the root and {}, so nothing can hold it in place; pin it instead"},
    {Check::kHoldsConflict, kSemantics,
     "{} and {} ({}) are held in frames {} to {} and both need {}, so they cannot be solved "
     "together; let go of one{}"},
    {Check::kHoldOnPin, kSemantics,
     "{} is pinned by {} in frames {} to {} already; remove the hold there"},
    {Check::kHoldConflictsPin, kSemantics,
     "holding {} needs {}, which also carries {}, pinned by {} in frames {} to {}; let go of "
     "one{}"},
    {Check::kHoldInGravity, kSemantics,
     "{} is held while gravity places the figure ({}) in frames {} to {}; hold it before or after, "
     "or pin it"},
    {Check::kLoopOfHolds, kSemantics,
     "region {} drives {}, which lies between the root and both {} and {}, held in frames {} to "
     "{}: a closed loop, which cannot swing; let go of one, or take the joint out of the region"},
    {Check::kLoopWithPin, kSemantics,
     "region {} drives {}, which lies between the root and both {}, held, and {}, pinned, in "
     "frames {} to {}: a closed loop, which cannot swing; let go of one, or take the joint out of "
     "the region"},
    {Check::kRegionInHold, kSemantics,
     "region {} drives {}, which the hold of {} ({}) needs in frames {} to {}; end one where the "
     "other begins, or take the joint out of the region"},
    {Check::kRootInHold, kSemantics,
     "region {} swings the root, which the hold of {} ({}) needs in frames {} to {}; end the hold "
     "before the region begins, or leave the root out of the region"},
    {Check::kWindsOverlap, kSemantics,
     "winds {} and {} both blow in frames {} to {}; end one where the other begins"},
    {Check::kForceInPaper, kSemantics,
     "{} acts in frames {} to {}, in which region {} has method \"paper\", which knows no forces "
     "from outside; choose method \"exact\" for it, or end one where the other begins"},
    {Check::kPushFeltByNone, kSemantics,
     "no region moves {} in frame {}, so that nothing can give way to {}; begin a region there "
     "that has it or a joint between it and the root, or move the push to a frame inside one"},
    {Check::kObjectNotHeld, kSemantics,
     "nobody has {} in frames {} to {}, and what flies or lies by itself cannot be constrained; "
     "let a joint have it all that time, or name an object of the scene"},
    {Check::kObjectChangesHands, kSemantics,
     "{} is not in one hand in all of the frames {} to {}: {}; end the constraint where it is let "
     "go, or name a joint"},
    {Check::kConstraintOnOneBody, kSemantics,
     "both ends are fixed to {}, so that neither can move against the other; fix one to something "
     "else"},
    {Check::kConstraintInWorld, kSemantics,
     "both ends are fixed in the world, so that neither can move; fix one to a joint or to what a "
     "joint holds"},
    {Check::kConstraintInPaper, kSemantics,
     "{} holds in frames {} to {}, in which region {} has method \"paper\", which knows no "
     "constraints; choose method \"exact\" for it, or end one where the other begins"},
    {Check::kContactInPaper, kSemantics,
     "region {} has contacts and method \"paper\", which knows no contacts; choose method "
     "\"exact\" for it, or let it touch nothing"},
    {Check::kObjectContactInPaper, kSemantics,
     "{} touches the scene and the solver's method is \"paper\", which knows no contacts; choose "
     "method \"exact\" for the solver, or let it touch nothing"},
    {Check::kBoxWithContacts, kSemantics,
     "{} is a box, and of what is let go only balls can touch the scene yet; make it a sphere, or "
     "let it touch nothing"},

    {Check::kUnknownField, kSchema, "unknown field {}; did you mean {}?"},
    {Check::kFixedLeftOut, kSemantics, "fixed by equal limits and left out of the region: {}"},
    {Check::kNothingToLandOn, kSemantics,
     "gravity without objects in the scene: there is nothing to land on"},
    {Check::kKeyOutsideLimits, kSemantics,
     "{} is outside the limits {} to {} of {}, and is kept; keys outside: {}"},
    {Check::kForceFeltByNone, kSemantics,
     "nothing feels {}: no region moves {} in frames {} to {}; add one, or remove the force"},
    {Check::kConstraintFeltByNone, kSemantics,
     "nothing feels {}: no region moves {} in frames {} to {}; add one, or remove the constraint"},
    {Check::kConstraintOutlasts, kSemantics,
     "from frame {} on nothing moves {}, so that {} has no effect up to its last frame {}; let a "
     "region move it as long, or end the constraint in frame {}"},
    {Check::kNothingToTouch, kSemantics,
     "region {} touches the scene, in which there is no plane or box; add one, or let it touch "
     "nothing"},
    {Check::kPinWhileTouching, kSemantics,
     "{} is not pinned: in frames {} to {} region {} moves the root and touches the scene, so that "
     "contact alone places the figure; leave the pin out, or the root out of the region"},

    {Check::kCannotWrite, kCannotWrite, "cannot be written: {}"},
    {Check::kCannotReplace, kCannotWrite, "cannot be replaced: {}"},
    {Check::kTooLargeToSave, kCannotWrite,
     "would be {}, which Hazumi does not read back (at most 160 MiB, and 600 MB in memory): use "
     "fewer keys (of a clip: --import with --reduce 1) or no skin (--no-skin)"},
};
static_assert(std::size(kTexts) == static_cast<size_t>(Check::kNumChecks));

constexpr bool InOrder() {
  for (size_t i = 0; i < std::size(kTexts); ++i) {
    if (static_cast<size_t>(kTexts[i].check) != i) return false;
  }
  return true;
}
static_assert(InOrder());

}  // namespace

const CheckText& TextOf(Check check) { return kTexts[static_cast<size_t>(check)]; }

std::string MessageOf(Check check, std::initializer_list<std::string_view> arguments) {
  std::string message;
  std::string_view text = TextOf(check).text;
  for (std::string_view argument : arguments) {
    const size_t hole = text.find("{}");
    HAZUMI_DEMAND(hole != std::string_view::npos);
    message.append(text.substr(0, hole)).append(argument);
    text.remove_prefix(hole + 2);
  }
  HAZUMI_DEMAND(text.find("{}") == std::string_view::npos);
  return message.append(text);
}

Error MakeError(Check check, std::string place, std::initializer_list<std::string_view> arguments) {
  return {TextOf(check).code, "", std::move(place), MessageOf(check, arguments)};
}

std::string Quoted(std::string_view name) {
  constexpr size_t kLongest = 60;
  size_t size = std::min(name.size(), kLongest);
  // A cut must not split a UTF-8 character.
  while (size < name.size() && size > 0 && (name[size] & 0xC0) == 0x80) --size;
  std::string text = "\"";
  for (char c : name.substr(0, size)) text += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  return text + (size < name.size() ? "...\"" : "\"");
}

std::string NumberText(double value) {
  if (value == 0.0) return "0";  // never "-0"
  char buffer[32];
  const auto end = std::to_chars(std::begin(buffer), std::end(buffer), value);
  return {buffer, end.ptr};
}

void FirstError::Report(Check check, const std::string& place,
                        std::initializer_list<std::string_view> arguments) {
  if (!error_) error_ = MakeError(check, place, arguments);
}

void FirstError::Report(Error error) {
  if (!error_) error_ = std::move(error);
}

void FirstError::Require(bool good, Check check, const std::string& place,
                         std::initializer_list<std::string_view> arguments) {
  if (!good) Report(check, place, arguments);
}

Error FirstError::In(const std::string& file) const {
  Error error = *error_;
  if (error.file.empty()) error.file = file;
  return error;
}

}  // namespace hazumi
