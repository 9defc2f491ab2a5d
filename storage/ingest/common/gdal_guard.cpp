#include "storage/ingest/common/gdal_guard.hpp"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_http.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <cpl_vsi_virtual.h>
#include <gdal.h>
#include <gdal_frmts.h>

#include <memory>
#include <mutex>
#include <string_view>
#include <vector>

CPL_C_START
void CPL_DLL RegisterOGRGeoJSON();
void CPL_DLL RegisterOGRGeoPackage();
void CPL_DLL RegisterOGRMEM();
void CPL_DLL RegisterOGRS57();
void CPL_DLL RegisterOGRShape();
CPL_C_END

namespace floeplan::ingest {
namespace {

void collect(CPLErr severity, CPLErrorNum /*number*/, const char* message) {
  if (severity != CE_Failure && severity != CE_Fatal) return;
  static_cast<GdalMessages*>(CPLGetErrorHandlerUserData())->add(message);
}

/// Replaces GDAL's request to a server by an error.
CPLHTTPResult* answer_nothing(const char* /*url*/, CSLConstList /*options*/, GDALProgressFunc /*progress*/,
                              void* /*of_progress*/, CPLHTTPFetchWriteFunc /*write*/, void* /*of_write*/,
                              void* /*own*/) {
  auto* const answer = static_cast<CPLHTTPResult*>(CPLCalloc(1, sizeof(CPLHTTPResult)));
  answer->nStatus = 1;
  answer->pszErrBuf = CPLStrdup("this program asks no server for a file");
  CPLError(CE_Failure, CPLE_HttpResponse, "%s", answer->pszErrBuf);
  return answer;
}

/// GDAL opens names that begin with "/vsi" on servers, in archives or through other names. A file may contain
/// such names, so all of them are closed, except GDAL's own memory "/vsimem/".
void close_other_ways_to_files() {
  CPLHTTPSetFetchCallback(&answer_nothing, nullptr);
  static const CPLStringList prefixes{VSIGetFileSystemsPrefixes()};  // GDAL keeps the pointers
  const std::unique_ptr<VSIFilesystemPluginCallbacksStruct, decltype(&VSIFreeFilesystemPluginCallbacksStruct)>
      calls{VSIAllocFilesystemPluginCallbacksStruct(), &VSIFreeFilesystemPluginCallbacksStruct};
  calls->open = [](void*, const char*, const char*) -> void* { return nullptr; };
  calls->stat = [](void*, const char*, VSIStatBufL*, int) { return -1; };
  // GDAL does not free the handlers that are replaced here. They live until the process ends.
  static auto* const replaced = new std::vector<VSIFilesystemHandler*>;
  for (int i = 0; i < prefixes.size(); ++i) {
    const std::string_view prefix{prefixes[i]};
    if (!prefix.starts_with("/vsi") || prefix == "/vsimem/") continue;
    replaced->push_back(VSIFileManager::GetHandler(prefixes[i]));
    VSIInstallPluginHandler(prefixes[i], calls.get());
  }
}

}  // namespace

void register_drivers() {
  static std::once_flag once;
  std::call_once(once, [] {
    // an .aux.xml file beside the data must not change their meaning
    CPLSetConfigOption("GDAL_PAM_ENABLED", "NO");
    // GDAL would take EASE-Grid 2 for the first one, whose places lie up to 20 km beside
    CPLSetConfigOption("OSR_USE_NON_DEPRECATED", "NO");
    close_other_ways_to_files();
    GDALRegister_GTiff();
    GDALRegister_netCDF();
    GDALRegister_Zarr();
    GDALRegister_GRIB();
    GDALRegister_BAG();
    GDALRegister_AAIGrid();
    GDALRegister_XYZ();
    GDALRegister_MEM();  // tables and polygons are laid on a grid in it; no file is read with it
    RegisterOGRGeoJSON();
    RegisterOGRGeoPackage();
    RegisterOGRMEM();  // the content of KML files is read into it
    RegisterOGRS57();
    RegisterOGRShape();
  });
}

std::string gdal_version() { return std::string{"GDAL "} + GDALVersionInfo("RELEASE_NAME"); }

GdalMessages::GdalMessages() { CPLPushErrorHandlerEx(&collect, this); }

GdalMessages::~GdalMessages() {
  CPLPopErrorHandler();
  CPLErrorReset();
}

std::string GdalMessages::first_error() const {
  return first_error_.empty() ? "no reason given" : first_error_;
}

}  // namespace floeplan::ingest
