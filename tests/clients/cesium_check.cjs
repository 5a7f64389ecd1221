// node cesium_check.cjs TILESET.json out.png: CesiumJS in headless Chromium, without network, loads the tileset until all
// its tiles are there, prints what it computed, saves a picture. Exit code 1 on any failure of a tile or of drawing.
// Needs npm's cesium and puppeteer-core on NODE_PATH, and /usr/bin/chromium.
const fs = require('fs');
const http = require('http');
const path = require('path');
const puppeteer = require('puppeteer-core');

const [tileset, picture] = process.argv.slice(2);
const data = path.dirname(path.resolve(tileset));
const cesium = path.join(path.dirname(require.resolve('cesium/package.json')), 'Build/Cesium');
const types = {
    '.js': 'text/javascript', '.json': 'application/json', '.html': 'text/html', '.css': 'text/css',
    '.wasm': 'application/wasm', '.glb': 'model/gltf-binary', '.png': 'image/png', '.jpg': 'image/jpeg',
};

// Runs in the page.
async function look(url) {
    const result = { errors: [] };
    try {
        const viewer = new Cesium.Viewer('view', {
            baseLayer: false, baseLayerPicker: false, geocoder: false, animation: false, timeline: false,
            homeButton: false, sceneModePicker: false, navigationHelpButton: false, fullscreenButton: false,
            infoBox: false, selectionIndicator: false,
        });
        viewer.scene.renderError.addEventListener((_, e) => result.errors.push('render ' + e));
        viewer.scene.globe.baseColor = Cesium.Color.fromCssColorString('#3a5f3a');
        viewer.scene.globe.depthTestAgainstTerrain = false;
        viewer.clock.currentTime = Cesium.JulianDate.fromIso8601('2026-06-21T19:00:00Z');
        const tiles = await Cesium.Cesium3DTileset.fromUrl(url);
        tiles.maximumScreenSpaceError = 1;
        let loaded = 0;
        tiles.tileFailed.addEventListener((e) => result.errors.push(`tile ${e.url} ${e.message}`));
        tiles.tileLoad.addEventListener(() => loaded++);
        viewer.scene.primitives.add(tiles);
        const sphere = tiles.boundingSphere;
        const center = Cesium.Cartographic.fromCartesian(sphere.center);
        result.center = [Cesium.Math.toDegrees(center.latitude), Cesium.Math.toDegrees(center.longitude), center.height];
        result.radius = sphere.radius;
        viewer.camera.viewBoundingSphere(sphere, new Cesium.HeadingPitchRange(
            Cesium.Math.toRadians(30), Cesium.Math.toRadians(-25), sphere.radius * 3));
        const start = Date.now();
        for (let calm = 0; calm < 5 && Date.now() - start < 60000;) {
            await new Promise((done) => setTimeout(done, 300));
            calm = tiles.tilesLoaded && loaded > 0 ? calm + 1 : 0;
        }
        result.loaded = tiles.tilesLoaded;
        result.tiles = loaded;
        result.triangles = tiles.statistics && tiles.statistics.numberOfTrianglesSelected;
        const middle = new Cesium.Cartesian2(viewer.canvas.width / 2, viewer.canvas.height / 2);
        const picked = viewer.scene.pick(middle);
        result.picked = !!(picked && (picked.primitive === tiles || picked.content));
    } catch (e) {
        result.errors.push('load ' + ((e && e.message) || e));
    }
    return result;
}

const page = `<!doctype html><script>window.CESIUM_BASE_URL = '/cesium/'</script><script src="/cesium/Cesium.js"></script>
<link rel="stylesheet" href="/cesium/Widgets/widgets.css"><style>html, body, #view { margin: 0; width: 100%; height: 100% }</style>
<div id="view"></div>`;

const server = http.createServer((request, response) => {
    const url = decodeURIComponent(request.url.split('?')[0]);
    if (url === '/') {
        response.setHeader('content-type', 'text/html');
        return response.end(page);
    }
    const file = url.startsWith('/cesium/') ? cesium + url.slice(7) : url.startsWith('/data/') ? data + url.slice(5) : null;
    if (!file || !fs.existsSync(file)) {
        response.statusCode = 404;
        return response.end();
    }
    response.setHeader('content-type', types[path.extname(file)] || 'application/octet-stream');
    fs.createReadStream(file).pipe(response);
});

server.listen(0, '127.0.0.1', async () => {
    const browser = await puppeteer.launch({
        executablePath: '/usr/bin/chromium',
        headless: true,
        args: [
            '--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
            '--ignore-gpu-blocklist', '--host-resolver-rules=MAP * ~NOTFOUND , EXCLUDE 127.0.0.1',
        ],
    });
    try {
        const tab = await browser.newPage();
        await tab.setViewport({ width: 640, height: 480 });
        tab.on('pageerror', (e) => console.log('page error', e.message));
        await tab.goto(`http://127.0.0.1:${server.address().port}/`);
        const result = await tab.evaluate(look, '/data/' + path.basename(tileset));
        await new Promise((done) => setTimeout(done, 500));
        await tab.screenshot({ path: picture });
        console.log(JSON.stringify(result));
        if (result.errors.length || !result.loaded) process.exitCode = 1;
    } catch (e) {
        console.log('FAILED', e.message);
        process.exitCode = 1;
    } finally {
        await browser.close();
        server.close();
    }
});
