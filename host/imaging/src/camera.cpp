// Cameras: perspective and orthographic with a thin lens, and the environment (panorama) camera.
#include <array>
#include <cmath>
#include <memory_resource>
#include <numbers>

#include "aperture.h"
#include "camera_settings.h"
#include "lxs/imaging/imaging.h"
#include "lxs/sdk/warp.h"

namespace lxs {
namespace {

using Vec3d = Imath::V3d;

struct Point2 {
    double x, y;
};

/// Film position in pixels of the window -> screen coordinates (y up).
class Screen {
  public:
    Screen(const CameraSettings& settings, const FilmFrame& frame)
        : x_step_((settings.screen[1] - settings.screen[0]) / frame.x_resolution),
          y_step_((settings.screen[2] - settings.screen[3]) / frame.y_resolution),
          x_origin_(settings.screen[0] + frame.x * x_step_),
          y_origin_(settings.screen[3] + frame.y * y_step_) {}

    Point2 at(const Vec2& film) const {
        return {x_origin_ + film.x * x_step_, y_origin_ + film.y * y_step_};
    }
    double pixel_area() const { return std::abs(x_step_ * y_step_); }

  private:
    double x_step_, y_step_, x_origin_, y_origin_;
};

/// What all cameras share: the frame of camera space in the world, depths, shutter, medium.
class LensCamera : public SceneCamera {
  public:
    LensCamera(const CameraSettings& settings, const FilmFrame& frame)
        : settings_(settings),
          x_axis_(axis(settings.to_world, 0)),
          y_axis_(axis(settings.to_world, 1)),
          z_axis_(axis(settings.to_world, 2)),
          position_(axis(settings.to_world, 3)),
          forward_(z_axis_.normalized()),
          middle_(0.5f * static_cast<float>(frame.x_resolution) - static_cast<float>(frame.x),
                  0.5f * static_cast<float>(frame.y_resolution) - static_cast<float>(frame.y)) {}

    float shutter_open() const override { return settings_.shutter_open; }
    float shutter_close() const override { return settings_.shutter_close; }
    double focal_distance() const override { return settings_.focal_distance; }
    bool has_lens() const override { return settings_.lens_radius != 0; }
    void set_media(const EnteredMedia& media) override { media_ = media; }

    void focus(const Scene& scene) override {
        if (!settings_.autofocus) return;
        // Through the lens's centre, where no focal distance matters.
        const Ray ray = generate({middle_, aperture_centre(settings_.blades)}, shutter_open()).ray;
        std::array<std::byte, 4096> buffer;
        std::pmr::monotonic_buffer_resource memory(buffer.data(), buffer.size());
        SurfaceHit hit;
        if (!scene.intersect(ray, hit, memory)) return;
        const double depth = ((Vec3d(hit.p) - position_) ^ forward_) / z_axis_.length();
        if (depth > 0) settings_.focal_distance = depth;
    }

  protected:
    const CameraSettings& settings() const { return settings_; }
    const Vec3d& x_axis() const { return x_axis_; }
    const Vec3d& y_axis() const { return y_axis_; }
    const Vec3d& z_axis() const { return z_axis_; }
    const Vec3d& position() const { return position_; }

    Vec3d to_world(double x, double y, double z) const {
        return x_axis_ * x + y_axis_ * y + z_axis_ * z;
    }

    /// The ray from `origin` along `step`, the way in the world per unit of camera-space depth, and
    /// as long as `length`, between the clipping depths.
    CameraRay clipped_ray(const Vec3d& origin, const Vec3d& step, double length, float time) const {
        CameraRay result;
        result.ray.origin = Vec3(origin + step * settings_.hither);
        result.ray.direction = Vec3(step / length);
        result.ray.time = time;
        result.ray.media = media_;
        if (settings_.yon < 1e30) {
            result.ray.t_max = static_cast<float>((settings_.yon - settings_.hither) * length);
        }
        const double depth = step ^ forward_;
        result.depth = static_cast<float>(depth * settings_.hither);
        result.depth_per_distance = static_cast<float>(depth / length);
        return result;
    }

    /// Point of the lens plane for this sample, camera space.
    Point2 lens_point(const CameraSample& sample) const {
        if (settings_.lens_radius == 0) return {0, 0};
        const Imath::V2d p = aperture_point(sample.lens, settings_.blades);
        return {p.x * settings_.lens_radius, p.y * settings_.lens_radius};
    }

  private:
    static Vec3d axis(const Matrix& m, int row) { return {m[row][0], m[row][1], m[row][2]}; }

    CameraSettings settings_;
    Vec3d x_axis_, y_axis_, z_axis_, position_;
    Vec3d forward_;  ///< the camera's axis, unit
    Vec2 middle_;    ///< of the whole image, pixels of the window
    EnteredMedia media_;
};

class PerspectiveCamera final : public LensCamera {
  public:
    PerspectiveCamera(const CameraSettings& settings, const FilmFrame& frame)
        : LensCamera(settings, frame),
          screen_(settings, frame),
          tangent_(std::tan(settings.fov / 360 * std::numbers::pi)),
          pixel_volume_(screen_.pixel_area() * tangent_ * tangent_ *
                        std::abs(x_axis().cross(y_axis()).dot(z_axis()))) {}

    CameraRay generate(const CameraSample& sample, float time) const override {
        const Point2 p = screen_.at(sample.film);
        const Point2 lens = lens_point(sample);
        // Where this ray meets the plane of focus, seen from the lens point, per unit of depth.
        const Vec3d step = to_world(p.x * tangent_ - lens.x / settings().focal_distance,
                                    p.y * tangent_ - lens.y / settings().focal_distance, 1);
        const double length = step.length();
        CameraRay result =
            clipped_ray(position() + to_world(lens.x, lens.y, 0), step, length, time);
        // The pixel's parallelogram at depth 1, seen along the ray, divided by the distance squared
        // is its solid angle; the footprint's radius is half a side of the square of that area.
        const double solid_angle = pixel_volume_ / (length * length * length);
        result.spread = static_cast<float>(0.5 * std::sqrt(solid_angle));
        result.width = static_cast<float>(result.spread * settings().hither * length);
        return result;
    }

  private:
    Screen screen_;
    double tangent_;
    double pixel_volume_;  ///< pixel at depth 1 times depth 1, world units
};

class OrthographicCamera final : public LensCamera {
  public:
    OrthographicCamera(const CameraSettings& settings, const FilmFrame& frame)
        : LensCamera(settings, frame),
          screen_(settings, frame),
          pixel_volume_(screen_.pixel_area() * std::abs(x_axis().cross(y_axis()).dot(z_axis()))) {}

    CameraRay generate(const CameraSample& sample, float time) const override {
        const Point2 p = screen_.at(sample.film);
        const Point2 lens = lens_point(sample);
        const Vec3d step =
            to_world(-lens.x / settings().focal_distance, -lens.y / settings().focal_distance, 1);
        const double length = step.length();
        CameraRay result =
            clipped_ray(position() + to_world(p.x + lens.x, p.y + lens.y, 0), step, length, time);
        result.width = static_cast<float>(0.5 * std::sqrt(pixel_volume_ / length));
        return result;
    }

  private:
    Screen screen_;
    double pixel_volume_;
};

/// Where the directions around a camera lie in its image.
class EnvironmentCamera : public LensCamera {
  public:
    EnvironmentCamera(const CameraSettings& settings, const FilmFrame& frame)
        : LensCamera(settings, frame), frame_(frame) {}

    CameraRay generate(const CameraSample& sample, float time) const final {
        const View view = look((sample.film.x + frame_.x) / frame_.x_resolution,
                               (sample.film.y + frame_.y) / frame_.y_resolution);
        const Vec3d step = to_world(view.direction.x, view.direction.y, view.direction.z);
        const double length = step.length();
        CameraRay result = clipped_ray(position(), step, length, time);
        result.spread = static_cast<float>(0.5 * std::sqrt(view.solid_angle));
        result.width = static_cast<float>(result.spread * settings().hither * length);
        result.depth = static_cast<float>(settings().hither * length);
        result.depth_per_distance = 1;
        return result;
    }

  protected:
    struct View {
        Vec3d direction;         ///< camera space, unit
        double solid_angle = 0;  ///< of a pixel
    };
    /// At a place of the image, both coordinates in [0, 1], the first row at 0.
    virtual View look(double x, double y) const = 0;
    const FilmFrame& frame() const { return frame_; }

  private:
    FilmFrame frame_;
};

/// Longitude to the right over the image's width, its centre forward; latitude from +y (top) to -y.
class EquirectangularCamera final : public EnvironmentCamera {
  public:
    EquirectangularCamera(const CameraSettings& settings, const FilmFrame& frame)
        : EnvironmentCamera(settings, frame),
          longitude_step_(2 * std::numbers::pi / frame.x_resolution),
          latitude_step_(std::numbers::pi / frame.y_resolution) {}

  private:
    View look(double x, double y) const override {
        const double longitude = (2 * x - 1) * std::numbers::pi, polar = y * std::numbers::pi;
        const double sine = std::sin(polar);
        // At the poles a pixel is no narrower than the sine half a pixel away makes it.
        return {Vec3d(sine * std::sin(longitude), std::cos(polar), sine * std::cos(longitude)),
                longitude_step_ * latitude_step_ * std::max(std::abs(sine), latitude_step_ / 2)};
    }

    double longitude_step_, latitude_step_;
};

/// A sphere unfolded as an octahedron, +y in the middle and forward in the middle of the lower
/// edge.
class EqualAreaCamera final : public EnvironmentCamera {
  public:
    using EnvironmentCamera::EnvironmentCamera;

  private:
    View look(double x, double y) const override {
        const Vec3d w = square_to_equal_area_sphere({x, y});
        return {Vec3d(w.x, w.z, w.y),
                4 * std::numbers::pi / (double(frame().x_resolution) * frame().y_resolution)};
    }
};

std::unique_ptr<SceneCamera> make_still_camera(const CameraSettings& settings,
                                               const FilmFrame& frame) {
    switch (settings.projection) {
        case Projection::Orthographic:
            return std::make_unique<OrthographicCamera>(settings, frame);
        case Projection::Environment:
            if (settings.mapping == SphereMapping::EqualArea)
                return std::make_unique<EqualAreaCamera>(settings, frame);
            return std::make_unique<EquirectangularCamera>(settings, frame);
        case Projection::Perspective:
            break;
    }
    return std::make_unique<PerspectiveCamera>(settings, frame);
}

/// A camera that stands in its own space, and that space's way through the world.
class MovingCamera final : public SceneCamera {
  public:
    MovingCamera(const CameraSettings& settings, const FilmFrame& frame)
        : settings_(settings), frame_(frame), path_(settings.motion) {
        settings_.to_world = Matrix();
        camera_ = make_still_camera(settings_, frame_);
    }

    float shutter_open() const override { return camera_->shutter_open(); }
    float shutter_close() const override { return camera_->shutter_close(); }
    double focal_distance() const override { return camera_->focal_distance(); }
    bool has_lens() const override { return camera_->has_lens(); }
    void set_media(const EnteredMedia& media) override { camera_->set_media(media); }

    /// Where the camera stands when the shutter opens.
    void focus(const Scene& scene) override {
        CameraSettings opening = settings_;
        opening.to_world = path_.at(shutter_open());
        const auto still = make_still_camera(opening, frame_);
        still->focus(scene);
        settings_.focal_distance = still->focal_distance();
        camera_ = make_still_camera(settings_, frame_);
    }

    CameraRay generate(const CameraSample& sample, float time) const override {
        CameraRay result = camera_->generate(sample, time);
        const Matrix to_world = path_.at(time);
        Vec3d origin, direction;
        to_world.multVecMatrix(Vec3d(result.ray.origin), origin);
        to_world.multDirMatrix(Vec3d(result.ray.direction), direction);
        const double stretch = direction.length();
        result.ray.origin = Vec3(origin);
        result.ray.direction = Vec3(direction / stretch);
        result.ray.t_max *= static_cast<float>(stretch);
        result.width *= static_cast<float>(stretch);
        result.depth *= static_cast<float>(stretch);
        return result;
    }

  private:
    CameraSettings settings_;
    FilmFrame frame_;
    MotionPath path_;
    std::unique_ptr<SceneCamera> camera_;
};

}  // namespace

std::unique_ptr<SceneCamera> make_camera(const SceneContents& contents, const Film& film,
                                         Diagnostics& diagnostics) {
    FilmFrame frame = read_film_frame(contents);
    frame.width = film.width();
    frame.height = film.height();
    const CameraSettings settings = read_camera_settings(contents, frame, diagnostics);
    if (settings.motion.empty()) return make_still_camera(settings, frame);
    return std::make_unique<MovingCamera>(settings, frame);
}

}  // namespace lxs
