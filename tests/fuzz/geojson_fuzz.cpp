// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <string_view>

#include "cad2slam/io/feature_csv.h"
#include "cad2slam/io/geojson_file.h"
#include "fuzz/require.h"

using namespace cad2slam;

/// GeoJSON, or CSV where the input is none: what is read is written and read as the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  const std::string_view text(reinterpret_cast<const char*>(bytes), count);
  const Result<FeatureList> table = parseFeatureCsv(text, "a.csv");
  if (table) {
    const std::string written = formatFeatureCsv(*table);
    const Result<FeatureList> again = parseFeatureCsv(written, "a.csv");
    fuzz::require(table->empty() || (again.has_value() && formatFeatureCsv(*again) == written), "no fixed point (CSV)");
  }
  const Result<FeatureList> features = parseGeoJson(text, "a.geojson");
  if (!features) {
    fuzz::require(!features.error().message.empty(), "error without message");
    return 0;
  }
  const Result<std::string> written = formatGeoJson(*features, "map");
  fuzz::require(written.has_value(), "read but not written");
  const Result<FeatureList> again = parseGeoJson(*written, "a.geojson");
  fuzz::require(again.has_value() && *formatGeoJson(*again, "map") == *written, "no fixed point (GeoJSON)");
  return 0;
}
