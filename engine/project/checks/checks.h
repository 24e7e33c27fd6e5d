#pragma once

// Internal. Every complaint of this folder, numbered: its code and its sentence stand in one table,
// so that a test can show that each of them is reached.

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"

namespace hazumi {

enum class Check {
  // The file and its text
  kCannotRead,
  kNotAFile,
  kFileTooBig,
  kNotUtf8,
  kNotJson,
  kNumberOverflow,
  kTooDeep,
  kTooManyValues,
  kFieldTwice,
  // One field
  kNotAProject,
  kNotAFigure,
  kNotPoses,
  kNotASweep,
  kNewerFormat,
  kUnknownFormat,
  kMissingField,
  kMisspelledField,
  kWrongType,
  kNumberTooLarge,
  kNotWhole,
  kWrongCount,
  kUnknownChoice,
  kNotOneOf,
  kBadColor,
  kNotFinite,
  kNotPositive,
  kNegative,
  kRange,
  kZeroVector,
  kNotUnit,
  kEmptyName,
  // The figure
  kUnknownParent,
  kTooManyJoints,
  kFigureUnreadable,
  kNotBytes,
  kBadMesh,
  // The document
  kBadFrameRate,
  kFramesReversed,
  kTooManyFrames,
  kNewerSolver,
  kKeyOrder,
  kKeyTwice,
  kSpanEmpty,
  kRegionEmpty,
  kDriveEmpty,
  kSetEmpty,
  kFillEmpty,
  kFillsOverlap,
  kGoalEmpty,
  kNameTwice,
  kNoView,
  kReleaseByNobody,
  kHoldersOverlap,
  kPositionIncomplete,
  // Names
  kUnknownJoint,
  kKeysOnGroup,
  kRootInRegion,
  kRootNotAJoint,
  kFrictionOnRoot,
  kFrictionNotInRegion,
  kDriveOnRoot,
  kDriveNotInRegion,
  kDrivenTwice,
  kUnknownObject,
  kAmbiguousObject,
  kJointAndObject,
  // What spans several parts
  kOutsideFrames,
  kReleaseOutside,
  kPlacedByNobody,
  kDriveFrozen,
  kDriveSplitsBall,
  kDriveWithoutStrength,
  kDriveCurveOutside,
  kRegionsOverlap,
  kMethodsDiffer,
  kMethodInGravity,
  kRegionAllFixed,
  kPlacementsOverlap,
  kNothingToSolve,
  kHoldsConflict,
  kHoldOnPin,
  kHoldConflictsPin,
  kHoldInGravity,
  kLoopOfHolds,
  kLoopWithPin,
  kRegionInHold,
  kRootInHold,
  kWindsOverlap,
  kForceInPaper,
  kPushFeltByNone,
  kObjectNotHeld,
  kObjectChangesHands,
  kConstraintOnOneBody,
  kConstraintInWorld,
  kConstraintInPaper,
  kContactInPaper,
  kObjectContactInPaper,
  kBoxWithContacts,
  // Warnings
  kUnknownField,
  kFixedLeftOut,
  kNothingToLandOn,
  kKeyOutsideLimits,
  kForceFeltByNone,
  kConstraintFeltByNone,
  kConstraintOutlasts,
  kNothingToTouch,
  kPinWhileTouching,
  // Writing
  kCannotWrite,
  kCannotReplace,
  kTooLargeToSave,
  kNumChecks
};

struct CheckText {
  Check check;
  ErrorCode code;    // of a warning: not used
  const char* text;  // each {} stands for an argument
};

const CheckText& TextOf(Check check);

std::string MessageOf(Check check, std::initializer_list<std::string_view> arguments);
Error MakeError(Check check, std::string place,
                std::initializer_list<std::string_view> arguments = {});

// The name in quotes, cut short and without control characters.
std::string Quoted(std::string_view name);

// The shortest text that reads back as the same number.
std::string NumberText(double value);

// Keeps the first error of several checks.
class FirstError {
 public:
  void Report(Check check, const std::string& place,
              std::initializer_list<std::string_view> arguments = {});
  void Report(Error error);
  // Reports unless `good`.
  void Require(bool good, Check check, const std::string& place,
               std::initializer_list<std::string_view> arguments = {});
  bool ok() const { return !error_; }
  const std::optional<Error>& error() const { return error_; }
  // The error, with its file named unless it names one.
  Error In(const std::string& file) const;

 private:
  std::optional<Error> error_;
};

}  // namespace hazumi
