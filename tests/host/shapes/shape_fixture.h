// Calls shape factories with parameters as a scene would give them.
#pragma once

#include <string>
#include <vector>

#include "lxs/scene/registry.h"

namespace lxs::test {

ParameterValue numbers(const std::string& type, const std::string& name,
                       std::vector<double> values);
ParameterValue text(const std::string& name, const std::string& value);
ParameterValue flag(const std::string& name, bool value);

/// Warnings of all kinds, in order.
class RecordedDiagnostics : public Diagnostics {
  public:
    void warning(const SourceLocation& where, const std::string& message) override;
    void unknown_parameter(const SourceLocation& where, const std::string& message) override;
    void fallback(const SourceLocation& where, const std::string& message,
                  const std::string& instead) override;
    bool lenient = false;  ///< goes on where LuxRender does
    std::vector<std::string> warnings;
    std::vector<std::uint32_t> lines;  ///< of each warning
};

/// The i-th parameter stands in line i + 2 of the scene, the statement itself in line 1.
Geometry make_shape(const std::string& plugin, std::vector<ParameterValue> values,
                    RecordedDiagnostics& diagnostics, const Matrix& to_world = Matrix());
TriangleMesh make_mesh(const std::string& plugin, std::vector<ParameterValue> values,
                       const Matrix& to_world = Matrix());

/// Text of the InputError that make_shape throws; empty if it throws none.
std::string error_of(const std::string& plugin, std::vector<ParameterValue> values,
                     const Matrix& to_world = Matrix());

}  // namespace lxs::test
