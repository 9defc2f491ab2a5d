#include "storage/ingest/gdal_guard.hpp"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal.h>
#include <gdal_frmts.h>

#include <mutex>

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

}  // namespace

void register_drivers() {
  static std::once_flag once;
  std::call_once(once, [] {
    CPLSetConfigOption("GDAL_PAM_ENABLED", "NO");  // a file beside the data must not change what they mean
    GDALRegister_GTiff();
    GDALRegister_netCDF();
    GDALRegister_Zarr();
    GDALRegister_GRIB();
    GDALRegister_BAG();
    GDALRegister_AAIGrid();
    GDALRegister_XYZ();
    GDALRegister_MEM();  // target of a resampling, never a source
    RegisterOGRGeoJSON();
    RegisterOGRGeoPackage();
    RegisterOGRMEM();  // what a KML file holds, as it was read
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
