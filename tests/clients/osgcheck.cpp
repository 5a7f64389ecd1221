// osgcheck MODEL [PICTURE.png [AZIMUTH ELEVATION [DISTANCE]]]
//
// Loads a model as any OpenSceneGraph simulator does, prints what it got, and draws it where a picture is asked for
// (that needs a display: xvfb-run). AZIMUTH, ELEVATION: where the eye is, degrees; DISTANCE: 1 fills the picture.
// Exit code 1: not readable, no triangle, a texture without its image, or the reader reported an error.
//
// OpenSceneGraph also looks for textures in the working folder: run this from an empty one.
//
// g++ -O1 -o osgcheck osgcheck.cpp -losg -losgDB -losgViewer -losgUtil -losgGA -lOpenThreads

#include <cmath>
#include <cstdlib>
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

bool draw(osg::Node* model, const osg::BoundingBox& box, const char* path, double azimuth, double elevation, double distance) {
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
    camera->setClearColor(osg::Vec4(.55, .65, .8, 1));
    camera->setDrawBuffer(GL_FRONT);
    camera->setReadBuffer(GL_FRONT);
    viewer.setSceneData(model);
    viewer.realize();

    const double half_view = osg::DegreesToRadians(20.0), radius = box.radius();
    const double a = osg::DegreesToRadians(azimuth), e = osg::DegreesToRadians(elevation);
    const osg::Vec3d centre = box.center(), towards(cos(e) * cos(a), cos(e) * sin(a), sin(e));
    camera->setProjectionMatrixAsPerspective(40, 1, radius / 50, radius * 200 * distance);
    camera->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    const osg::Vec3d eye = centre + towards * (radius / sin(half_view) * distance);
    camera->setViewMatrixAsLookAt(eye, centre, osg::Vec3d(0, 0, 1));
    osg::ref_ptr<osg::Image> picture = new osg::Image;
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
        std::cout << "usage: osgcheck MODEL [PICTURE.png [AZIMUTH ELEVATION [DISTANCE]]]\n";
        return 2;
    }
    osg::ref_ptr<Complaints> complaints = new Complaints;
    osg::setNotifyHandler(complaints);
    osg::setNotifyLevel(osg::INFO);
    osg::ref_ptr<osg::Node> model = osgDB::readRefNodeFile(values[1]);
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
              << box.zMax() << "\n";
    for (const std::string& comment : model->getDescriptions()) std::cout << "  comment: " << comment << "\n";
    bool good = survey.triangles > 0 && survey.missing_images == 0 && complaints->errors == 0;
    if (count > 2) {
        const double azimuth = argument(count, values, 3, -50), elevation = argument(count, values, 4, 20);
        good = draw(model, box, values[2], azimuth, elevation, argument(count, values, 5, 1)) && good;
    }
    std::cout << (good ? "OK" : "FAILED") << "\n";
    return good ? 0 : 1;
}
