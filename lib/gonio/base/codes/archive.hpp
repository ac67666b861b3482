// Diagnostic codes of archives and of what is in them: zip, GLDF.
#pragma once

#include <gonio/base/diagnostic_codes.hpp>

#include <array>

namespace gonio {

inline constexpr auto archive_codes = std::to_array<DiagnosticCode>({
    {"ARC0101", Severity::error, Strict::same, "broken archive",
     "The file is not a zip archive or ends too early, its directory and its entries contradict each other, or an "
     "entry does not unpack to the bytes that its checksum states."},
    {"ARC0102", Severity::error, Strict::same, "archive beyond a limit",
     "The archive has more entries than gonio allows, or entries that unpack to more bytes, in all or against the "
     "bytes that they take in the archive. 'gonio list limits' shows the limits."},
    {"ARC0103", Severity::error, Strict::same, "name that leads out of an archive",
     "An entry has an absolute name, a drive, a '..', characters that no file name has or more than 1024 bytes. Such "
     "an archive could write or read files outside its folder, so gonio reads nothing of it."},
    {"ARC0104", Severity::error, Strict::same, "name given twice in an archive",
     "Two entries have the same name, or names that differ by upper and lower case only. Programs disagree about which "
     "of them counts."},
    {"ARC0105", Severity::error, Strict::same, "encrypted archive",
     "An entry is encrypted. gonio does not read encrypted archives."},
    {"ARC0106", Severity::error, Strict::same, "archive of another kind",
     "gonio reads entries that are stored or deflated, in archives of one part below 4 GiB: not ZIP64, and no other "
     "compression."},
    {"ARC0107", Severity::error, Strict::same, "missing in an archive",
     "The archive does not have the file that makes it what it should be: product.xml of GLDF, description.xml of "
     "GDTF, the layer of USDZ."},

    {"ARC0201", Severity::error, Strict::same, "not well-formed XML in an archive",
     "The XML breaks the rules at this place, or its outermost element is another one."},
    {"ARC0202", Severity::error, Strict::same, "document type in an archive",
     "The XML declares a document type. GLDF and GDTF have none, and entities that are declared in one can grow "
     "without end, so gonio reads no such file."},
    {"ARC0203", Severity::error, Strict::same, "XML in an archive beyond a limit",
     "The XML is larger or nested deeper than gonio allows. 'gonio list limits' shows the limits."},

    {"GLD0101", Severity::error, Strict::same, "no photometry in GLDF",
     "The GLDF, or the variant or emitter that was asked for, names no photometric file that is in the archive and can "
     "be read. Descriptive values alone are not a light distribution."},

    {"GLD0201", Severity::warning, Strict::error, "required element missing in GLDF",
     "The schema of GLDF requires this element or attribute."},
    {"GLD0202", Severity::warning, Strict::error, "reference to nothing in GLDF",
     "An identifier is referred to, but no element of that kind has it. What refers to it is left out."},
    {"GLD0203", Severity::warning, Strict::error, "identifier given twice in GLDF",
     "Two elements of a kind have the same identifier. References mean the first."},
    {"GLD0204", Severity::warning, Strict::error, "invalid value in GLDF",
     "The element or attribute does not have the form that the schema of GLDF gives it. It is taken as not given."},
    {"GLD0205", Severity::warning, Strict::error, "file missing in GLDF",
     "product.xml names a file that is not in the archive. GLDF looks for it in the folder that its content type "
     "names: "
     "ldc, geo, image, spectrum."},
    {"GLD0206", Severity::note, Strict::same, "file elsewhere than in the GLDF",
     "product.xml names a file by its address on the network. gonio never opens one."},
    {"GLD0207", Severity::note, Strict::same, "file that the GLDF does not name",
     "The archive has a file that product.xml does not mention. gonio does not read it."},
    {"GLD0208", Severity::warning, Strict::same, "flux of an emitter differs from its photometry",
     "The luminous flux that product.xml states for an emitter is more than 1 % off the integral of its photometric "
     "file. Variants of different flux often share one file. gonio takes the file's numbers where it reads a profile, "
     "and the stated flux where it reads lights."},
    {"GLD0209", Severity::warning, Strict::same, "one of several photometries",
     "The GLDF or its variant has several photometric files, and the command takes the first that it can read. "
     "--variant and --emitter choose another."},
    {"GLD0210", Severity::note, Strict::same, "other version of GLDF",
     "gonio knows the versions 1.0, release candidates included. The file is read as one of them."},
    {"GLD0211", Severity::warning, Strict::same, "photometry of a GLDF that cannot be read",
     "A photometric file in the archive is broken. The message states why."},

    {"GLD0301", Severity::note, Strict::same, "stated in a GLDF without a source",
     "GLDF requires something that the profile does not state, so gonio writes what the message says."},
});
static_assert(in_order(archive_codes));

using ArchiveCode = CodeOf<archive_codes>;

} // namespace gonio
