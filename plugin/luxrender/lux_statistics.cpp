// What LuxRender's console and interface show of a render by aips.
#include "lux_statistics.h"

#include <sstream>

namespace aips::luxrender {

class LuxStatistics::Long final : public lux::RendererStatistics::FormattedLong {
  public:
    explicit Long(LuxStatistics& of) : FormattedLong(&of), of_(of) {}

  private:
    std::string getRecommendedStringTemplate() override { return "%elapsedTime% - %progress%"; }
    std::string getProgress() override { return of_.progress(); }
    LuxStatistics& of_;
};

class LuxStatistics::Short final : public lux::RendererStatistics::FormattedShort {
  public:
    explicit Short(LuxStatistics& of) : FormattedShort(&of), of_(of) {}

  private:
    std::string getRecommendedStringTemplate() override { return "%elapsedTime% - %progress%"; }
    std::string getProgress() override { return of_.progress(); }
    LuxStatistics& of_;
};

LuxStatistics::LuxStatistics() {
    formattedLong = new Long(*this);
    formattedShort = new Short(*this);
}

LuxStatistics::~LuxStatistics() {
    delete formattedLong;
    delete formattedShort;
}

std::string LuxStatistics::progress() const {
    std::ostringstream text;
    text << passes << " passes, " << double(photon_paths) * 1e-6 << " M photon paths";
    return text.str();
}

}  // namespace aips::luxrender
