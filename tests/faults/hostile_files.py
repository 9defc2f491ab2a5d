"""Files that nobody means well with, each with some bytes of its own changed, of which nothing may be stored."""
import io
import pathlib
import sqlite3
import tempfile
import zipfile


def geopackage(call):
    """Points in a view that calls a function of SQLite's extensions when they are read."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "a.gpkg"
        with sqlite3.connect(file) as database:
            database.executescript(f"""
                PRAGMA application_id = 1196444487;
                PRAGMA user_version = 10300;
                CREATE TABLE gpkg_spatial_ref_sys (srs_name TEXT, srs_id INTEGER PRIMARY KEY, organization TEXT,
                    organization_coordsys_id INTEGER, definition TEXT, description TEXT);
                INSERT INTO gpkg_spatial_ref_sys VALUES ('WGS 84', 4326, 'EPSG', 4326,
                    'GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]]', '');
                CREATE TABLE gpkg_contents (table_name TEXT PRIMARY KEY, data_type TEXT, identifier TEXT, description TEXT,
                    last_change TEXT, min_x REAL, min_y REAL, max_x REAL, max_y REAL, srs_id INTEGER);
                CREATE TABLE gpkg_geometry_columns (table_name TEXT, column_name TEXT, geometry_type_name TEXT,
                    srs_id INTEGER, z INTEGER, m INTEGER);
                CREATE TABLE bergs (fid INTEGER PRIMARY KEY, id TEXT, observed TEXT);
                INSERT INTO bergs VALUES (1, 'a', '2026-11-20T06:00:00Z');
                CREATE VIEW evil AS SELECT fid, id, observed || coalesce({call}, '') AS observed FROM bergs;
                INSERT INTO gpkg_contents (table_name, data_type, identifier, srs_id) VALUES ('evil', 'attributes', 'evil', 0);
            """)
        return file.read_bytes()


def bomb():
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("bed.asc", b"0 " * 20_000_000)
    return packed.getvalue()


def climber(store):
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w") as archive:
        archive.writestr(f"../../{store.name}/floeplan.sqlite", b"gone")
    return packed.getvalue()


def grid_in(crs):
    return ('{"type": "FeatureCollection", "crs": {"type": "name", "properties": {"name": "' + crs + '"}}, "features": [{"type": '
            '"Feature", "properties": {"id": "a"}, "geometry": {"type": "Point", "coordinates": [-52, 69]}}]}').encode()


def sample_of(store):
    """(name, bytes) of every kind."""
    database = store / "floeplan.sqlite"
    return [
        ("proj.gpkg", geopackage(f"PROJ_SetDatabasePath('{database}')")),
        ("read.gpkg", geopackage("BlobFromFile('/etc/passwd')")),
        ("write.gpkg", geopackage(f"BlobToFile('gone', '{database}')")),
        ("layers.gpkg", geopackage("ogr_datasource_load_layers('/vsicurl/http://127.0.0.1:9/a')")),
        ("bomb.zip", bomb()),
        ("climber.zip", climber(store)),
        ("far.geojson", grid_in("http://127.0.0.1:9/crs")),
        ("file.geojson", grid_in(str(database))),
        ("a.vrt", f'<VRTDataset rasterXSize="9" rasterYSize="9"><VRTRasterBand dataType="Byte" band="1"><SimpleSource>'
                  f'<SourceFilename>{database}</SourceFilename></SimpleSource></VRTRasterBand></VRTDataset>'.encode()),
        ("huge.asc", b"ncols 2000000000\nnrows 2000000000\nxllcorner 0\nyllcorner 0\ncellsize 1e-9\n1 2 3\n"),
        ("cut.h5", b"\x89HDF\r\n\x1a\n" + bytes(200)),
        ("cut.grb2", b"GRIB\x00\x00\x00\x02" + (1 << 62).to_bytes(8, "big") + bytes(100)),
        ("database.sqlite", b"SQLite format 3\0" + bytes(4080)),
    ]


def spoilt(content, generator):
    """With up to three bytes changed behind the first 16, which say what the file is."""
    changed = bytearray(content)
    for _ in range(generator.randrange(4)):
        if len(changed) > 20:
            changed[generator.randrange(16, len(changed))] = generator.randrange(256)
    return bytes(changed)
