// Measured optical constants: reading and interpolation.
// Formats: SOPRA S.A.'s nk database as its files show it (first line: unit, first and last value,
// number of steps; then n and k); luxpop.com's tables (comments after ";", wavelength in
// Angstroms, n, k).
#include "optical_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <locale>
#include <sstream>

#include "metal_presets.h"

namespace lxs::shading {
namespace {

constexpr double kNmTimesElectronvolt = 1239.84198;  // h c / e (CODATA 2018)

using Row = std::vector<double>;

struct NumberFile {
    std::vector<Row> rows;
    std::size_t bad_line = 0;  ///< the first one that holds no numbers, from 1; 0: none
};

/// Lines of numbers. Empty lines and comments are left out.
NumberFile read_numbers(std::istream& file) {
    NumberFile result;
    std::string line;
    for (std::size_t number = 1; std::getline(file, line); ++number) {
        line = line.substr(0, line.find_first_of(";#!"));
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream words(line);
        words.imbue(std::locale::classic());
        Row row;
        double value = 0;
        while (words >> value)
            row.push_back(value);
        const bool rest = !words.eof();
        if (row.empty() && !rest) continue;
        if (rest || row.empty()) {
            if (result.bad_line == 0) result.bad_line = number;
            continue;
        }
        result.rows.push_back(std::move(row));
    }
    return result;
}

bool has_sopra_header(const std::vector<Row>& rows) {
    return rows.size() > 1 && rows[0].size() == 4 && rows[1].size() == 2 &&
           (rows[0][0] == 1 || rows[0][0] == 2);
}

/// Unit 1: electronvolts, 2: micrometres; `steps` intervals from `first` to `last`.
OpticalTable sopra_table(const std::vector<Row>& rows) {
    OpticalTable table;
    const Row& header = rows[0];
    const double count = std::max(1.0, header[3]);
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const double t = static_cast<double>(i - 1) / count;
        const double value = header[1] + (header[2] - header[1]) * t;
        if (rows[i].size() < 2 || !(value > 0)) return {};
        const double nm = header[0] == 1 ? kNmTimesElectronvolt / value : 1000 * value;
        table.push_back({nm, rows[i][0], rows[i][1]});
    }
    return table;
}

double nanometres_per_unit(const std::vector<Row>& rows, OpticalFormat format) {
    constexpr double kAngstrom = 0.1, kMicrometre = 1000;
    if (format == OpticalFormat::LuxPop) return kAngstrom;
    const double middle = rows[rows.size() / 2][0];
    return middle > 2000 ? kAngstrom : middle > 20 ? 1 : kMicrometre;
}

OpticalTable column_table(const std::vector<Row>& rows, OpticalFormat format) {
    OpticalTable table;
    if (rows.empty()) return table;
    const double unit = nanometres_per_unit(rows, format);
    for (const Row& row : rows) {
        if (row.size() < 2 || row.size() > 3) return {};
        table.push_back({row[0] * unit, row[1], row.size() == 3 ? row[2] : 0});
    }
    return table;
}

bool makes_sense(const OpticalTable& table) {
    return !table.empty() && std::all_of(table.begin(), table.end(), [](const auto& entry) {
        return entry.wavelength > 0 && entry.n > 0 && entry.k >= 0 && std::isfinite(entry.n) &&
               std::isfinite(entry.k);
    });
}

}  // namespace

OpticalTable read_optical_table(const std::string& path, OpticalFormat format,
                                const SourceLocation& where) {
    std::ifstream file(path);
    if (!file) throw InputError(where, fmt::format("\"{}\" can't be read", path));
    const NumberFile numbers = read_numbers(file);
    if (numbers.bad_line > 0)
        throw InputError(where, fmt::format("{}:{}: expected numbers", path, numbers.bad_line));
    const bool sopra = format == OpticalFormat::Sopra ||
                       (format == OpticalFormat::Any && has_sopra_header(numbers.rows));
    OpticalTable table;
    if (!sopra) {
        table = column_table(numbers.rows, format);
    } else if (has_sopra_header(numbers.rows)) {
        table = sopra_table(numbers.rows);
    }
    if (!makes_sense(table)) {
        throw InputError(where, fmt::format("\"{}\" is no table of optical constants ({})", path,
                                            sopra ? "Sopra" : "wavelength, n, k"));
    }
    std::sort(table.begin(), table.end(),
              [](const auto& a, const auto& b) { return a.wavelength < b.wavelength; });
    return table;
}

OpticalConstants constants_at(const OpticalTable& table, double wavelength) {
    const auto above = std::lower_bound(
        table.begin(), table.end(), wavelength,
        [](const OpticalConstants& entry, double value) { return entry.wavelength < value; });
    if (above == table.begin()) return table.front();
    if (above == table.end()) return table.back();
    const OpticalConstants &a = *(above - 1), &b = *above;
    const double t = (wavelength - a.wavelength) / (b.wavelength - a.wavelength);
    return {wavelength, a.n + t * (b.n - a.n), a.k + t * (b.k - a.k)};
}

FresnelValue rgb_constants(const OpticalTable& table) {
    FresnelValue value;
    for (int i = 0; i < 3; ++i) {
        const OpticalConstants at = constants_at(table, kRgbWavelengths[i]);
        value.eta[i] = static_cast<float>(at.n);
        value.k[i] = static_cast<float>(at.k);
    }
    value.conductor = !is_black(value.k);
    return value;
}

}  // namespace lxs::shading
