// osgcheck MODEL [PICTURE.png [AZIMUTH ELEVATION [METRES [unlit]]]]
//
// Loads a model as any OpenSceneGraph simulator does, prints what it got, and draws it where a picture is asked for
// (that needs a display: xvfb-run). AZIMUTH, ELEVATION: where the eye is, degrees; METRES: how far from the middle (0, the
// default, gives a view of 40 degrees). The view is as wide as the model at any distance, so that each level of detail fills
// the picture at its own. Where nothing is drawn the picture is transparent. `unlit` shows the textures as they are.
// Exit code 1: not readable, no triangle, a texture without its image, or the reader reported an error.
//
// OpenSceneGraph also looks for textures in the working folder: run this from an empty one.
//
// g++ -O1 -o osgcheck osgcheck.cpp -losg -losgDB -losgViewer -losgUtil -losgGA -lOpenThreads

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <set>
#include <string>

#include <osg/ComputeBoundsVisitor>
#include <osg/Geometry>
#include <osg/LOD>
#include <osg/Notify>
#include <osg/Texture2D>
#include <osg/Transform>
#include <osg/TriangleFunctor>
#include <osgDB/ReadFile>
#include <osgDB/WriteFile>
#include <osgViewer/Viewer>

namespace {

// Prints what the reader complains about and counts what makes a file wrong.
struct Complaints : osg::NotifyHandler {
    unsigned errors = 0;

    void notify(osg::NotifySeverity severity, const char* message) override {
        const std::string text(message);
        if (text.find_first_not_of(" \n") == text.npos) return;
        auto has = [&](const char* part) { return text.find(part) != text.npos; };
        // Lost textures and unknown records are mere information to the reader.
        const bool wrong = has("an't find texture") || has("read error") || has("Unknown record");
        // A plugin that is looked for in several places is no error.
        if (has("failed loading") || has("libosg.so")) return;
        if (wrong) errors++;
        if (wrong || severity <= osg::WARN) std::cout << "  OSG: " << text;
    }
};

struct CountTriangles {
    unsigned count = 0;
    void operator()(const osg::Vec3&, const osg::Vec3&, const osg::Vec3&, bool = false) { count++; }
};

struct Survey : osg::NodeVisitor {
    unsigned triangles = 0, drawables = 0, without_uv = 0, lods = 0, transforms = 0, missing_images = 0;
    std::set<const osg::Texture*> textures;
    bool quiet;

    explicit Survey(bool quiet) : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN), quiet(quiet) {}

    void apply(osg::Node& node) override {
        look_at(node.getStateSet());
        traverse(node);
    }

    void apply(osg::Transform& node) override {
        transforms++;
        look_at(node.getStateSet());
        traverse(node);
    }

    void apply(osg::LOD& lod) override {
        lods++;
        if (!quiet) describe(lod);
        look_at(lod.getStateSet());
        traverse(lod);
    }

    void apply(osg::Drawable& drawable) override {
        drawables++;
        look_at(drawable.getStateSet());
        osg::TriangleFunctor<CountTriangles> counter;
        drawable.accept(counter);
        triangles += counter.count;
        const osg::Geometry* geometry = drawable.asGeometry();
        if (geometry && !geometry->getTexCoordArray(0)) without_uv++;
    }

    void look_at(const osg::StateSet* state) {
        if (!state) return;
        for (unsigned unit = 0; unit < 4; unit++) {
            auto* texture = dynamic_cast<const osg::Texture2D*>(state->getTextureAttribute(unit, osg::StateAttribute::TEXTURE));
            if (!texture || !textures.insert(texture).second) continue;
            const osg::Image* image = texture->getImage();
            if (!image || !image->data()) {
                missing_images++;
                if (!quiet) std::cout << "  texture WITHOUT image\n";
            } else if (!quiet) {
                std::cout << "  texture " << image->getFileName() << " " << image->s() << "x" << image->t() << "\n";
            }
        }
    }

    static void describe(const osg::LOD& lod) {
        std::cout << "  LOD '" << lod.getName() << "' ranges";
        for (unsigned i = 0; i < lod.getNumRanges(); i++)
            std::cout << " [" << lod.getMinRange(i) << "," << lod.getMaxRange(i) << "]";
        std::cout << " triangles";
        for (unsigned i = 0; i < lod.getNumChildren(); i++) {
            Survey child(true);
            const_cast<osg::Node*>(lod.getChild(i))->accept(child);
            std::cout << " " << child.triangles;
        }
        std::cout << "\n";
    }
};

bool draw(osg::Node* model, const osg::BoundingBox& box, const char* path, double azimuth, double elevation, double distance,
          bool unlit) {
    const int size = 512;
    osg::ref_ptr<osg::GraphicsContext::Traits> traits = new osg::GraphicsContext::Traits;
    traits->width = traits->height = size;
    traits->pbuffer = true;
    traits->alpha = 8;
    traits->readDISPLAY();
    osg::ref_ptr<osg::GraphicsContext> context = osg::GraphicsContext::createGraphicsContext(traits.get());
    if (!context) {
        std::cout << "no OpenGL context (use xvfb-run)\n";
        return false;
    }
    osgViewer::Viewer viewer;
    viewer.setThreadingModel(osgViewer::Viewer::SingleThreaded);
    osg::Camera* camera = viewer.getCamera();
    camera->setGraphicsContext(context);
    camera->setViewport(0, 0, size, size);
    camera->setClearColor(osg::Vec4(.55, .65, .8, 0));
    camera->setDrawBuffer(GL_FRONT);
    camera->setReadBuffer(GL_FRONT);
    if (unlit) model->getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::OFF | osg::StateAttribute::OVERRIDE);
    viewer.setSceneData(model);
    viewer.realize();

    const double radius = box.radius();
    if (distance <= radius) distance = radius / sin(osg::DegreesToRadians(20.0));
    const double view = 2 * osg::RadiansToDegrees(asin(radius / distance));
    const double a = osg::DegreesToRadians(azimuth), e = osg::DegreesToRadians(elevation);
    const osg::Vec3d centre = box.center(), towards(cos(e) * cos(a), cos(e) * sin(a), sin(e));
    camera->setProjectionMatrixAsPerspective(view, 1, std::max(distance - 1.1 * radius, radius / 50), distance + 1.1 * radius);
    camera->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    const osg::Vec3d eye = centre + towards * distance;
    camera->setViewMatrixAsLookAt(eye, centre, osg::Vec3d(0, 0, 1));
    std::cout << std::setprecision(12) << "  camera eye " << eye.x() << " " << eye.y() << " " << eye.z() << " centre " << centre.x()
              << " " << centre.y() << " " << centre.z() << " view " << view << "\n";
    osg::ref_ptr<osg::Image> picture = new osg::Image;
    picture->allocateImage(size, size, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    camera->attach(osg::Camera::COLOR_BUFFER, picture.get());
    // The first frames compile what the last one draws.
    for (int frame = 0; frame < 3; frame++) viewer.frame();
    return osgDB::writeImageFile(*picture, path);
}

double argument(int count, char** values, int index, double otherwise) {
    return count > index ? atof(values[index]) : otherwise;
}

}  // namespace

int main(int count, char** values) {
    if (count < 2) {
        std::cout << "usage: osgcheck MODEL [PICTURE.png [AZIMUTH ELEVATION [METRES [unlit]]]]\n";
        return 2;
    }
    osg::ref_ptr<Complaints> complaints = new Complaints;
    osg::setNotifyHandler(complaints);
    osg::setNotifyLevel(osg::INFO);
    const auto start = std::chrono::steady_clock::now();
    osg::ref_ptr<osg::Node> model = osgDB::readRefNodeFile(values[1]);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    osg::setNotifyLevel(osg::WARN);
    if (!model) {
        std::cout << values[1] << ": NOT READABLE\nFAILED\n";
        return 1;
    }
    Survey survey(false);
    model->accept(survey);
    osg::ComputeBoundsVisitor bounds;
    model->accept(bounds);
    const osg::BoundingBox box = bounds.getBoundingBox();
    std::cout << values[1] << ": triangles " << survey.triangles << " drawables " << survey.drawables << " withoutUV "
              << survey.without_uv << " LODs " << survey.lods << " transforms " << survey.transforms << " textures "
              << survey.textures.size() << " missingImages " << survey.missing_images << "\n  bbox min " << box.xMin()
              << " " << box.yMin() << " " << box.zMin() << " max " << box.xMax() << " " << box.yMax() << " "
              << box.zMax() << "\n  read in " << taken.count() << " s\n";
    for (const std::string& comment : model->getDescriptions()) std::cout << "  comment: " << comment << "\n";
    bool good = survey.triangles > 0 && survey.missing_images == 0 && complaints->errors == 0;
    if (count > 2) {
        const double azimuth = argument(count, values, 3, -50), elevation = argument(count, values, 4, 20);
        const bool unlit = count > 6 && std::string(values[6]) == "unlit";
        good = draw(model, box, values[2], azimuth, elevation, argument(count, values, 5, 0), unlit) && good;
    }
    std::cout << (good ? "OK" : "FAILED") << "\n";
    return good ? 0 : 1;
}
