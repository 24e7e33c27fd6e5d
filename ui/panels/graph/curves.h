#pragma once

#include "ui/panels/graph/layout.h"

namespace hazumi::ui {

// Internal: the parts of a graph's curves.

// Without points.
GraphCurve CurveFor(const edit::Session& session, const std::string& name);
// Points of the baked motion: close ones where they are seen.
void SampleCurve(const edit::Session& session, const Motion& motion, const TimeAxis& axis,
                 GraphCurve* curve);
// The rates that the motion has at a key.
void RatesAt(const Motion& motion, const GraphCurve& curve, GraphKey* key);

}  // namespace hazumi::ui
