# Builds the scene of a job, bakes its GIProbe, saves one picture for each exposure, and times frames with a moving camera.
extends Spatial

const WARM_UP_FRAMES = 20  # a thread of the engine brings light into the probe meanwhile
const TIMED_FRAMES = 30

var environment = Environment.new()
var camera = Camera.new()


func vector(v):
	return Vector3(v[0], v[1], v[2])


# The engine converts colours from sRGB to linear.
func color(c):
	var encoded = []
	for x in c:
		encoded.append(12.92 * x if x <= 0.0031308 else 1.055 * pow(x, 1 / 2.4) - 0.055)
	return Color(encoded[0], encoded[1], encoded[2])


func mesh_of(surface):
	var arrays = []
	arrays.resize(Mesh.ARRAY_MAX)
	var positions = PoolVector3Array()
	var normals = PoolVector3Array()
	for first in range(0, surface.positions.size(), 9):
		for corner in [0, 2, 1]:  # clockwise is front
			var i = first + 3 * corner
			positions.append(Vector3(surface.positions[i], surface.positions[i + 1], surface.positions[i + 2]))
			normals.append(Vector3(surface.normals[i], surface.normals[i + 1], surface.normals[i + 2]))
	arrays[Mesh.ARRAY_VERTEX] = positions
	arrays[Mesh.ARRAY_NORMAL] = normals
	var mesh = ArrayMesh.new()
	mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
	var material = SpatialMaterial.new()
	material.albedo_color = color(surface.albedo)
	material.roughness = 1
	material.metallic_specular = 0
	material.params_diffuse_mode = SpatialMaterial.DIFFUSE_LAMBERT
	var strength = surface.emission.max()
	if strength > 0:
		material.emission_enabled = true
		material.emission = color([surface.emission[0] / strength, surface.emission[1] / strength, surface.emission[2] / strength])
		material.emission_energy = strength
	mesh.surface_set_material(0, material)
	var node = MeshInstance.new()
	node.mesh = mesh
	node.use_in_baked_light = true
	node.cast_shadow = GeometryInstance.SHADOW_CASTING_SETTING_DOUBLE_SIDED
	return node


func add_sun(sun, farthest):
	var strength = sun.irradiance.max()
	if strength == 0:
		return
	var light = DirectionalLight.new()
	light.light_color = color([sun.irradiance[0] / strength, sun.irradiance[1] / strength, sun.irradiance[2] / strength])
	light.light_energy = strength / PI  # a light of energy 1 gives pi lux
	light.light_specular = 0
	light.shadow_enabled = true
	light.shadow_bias = 0.0012 * farthest
	light.directional_shadow_normal_bias = 0
	light.directional_shadow_mode = DirectionalLight.SHADOW_ORTHOGONAL
	light.directional_shadow_max_distance = farthest
	add_child(light)
	var towards = vector(sun.towards)
	light.look_at_from_position(Vector3(), -towards, Vector3(0, 0, 1) if abs(towards.y) > 0.99 else Vector3(0, 1, 0))


func add_probe(bounds, settings):
	var probe = GIProbe.new()
	probe.subdiv = {64.0: GIProbe.SUBDIV_64, 128.0: GIProbe.SUBDIV_128, 256.0: GIProbe.SUBDIV_256}[settings.subdiv]
	probe.extents = 0.5 * 1.02 * (vector(bounds[1]) - vector(bounds[0]))
	for axis in range(3):
		probe.extents[axis] = max(probe.extents[axis], 0.02 * probe.extents.length())
	probe.translation = 0.5 * (vector(bounds[1]) + vector(bounds[0]))
	probe.interior = true  # no light from an environment
	for name in settings:
		if name != "subdiv" and name != "offset_voxels":
			probe.set(name, settings[name])
	var longest = max(max(probe.extents.x, probe.extents.y), probe.extents.z)
	probe.normal_bias = settings.offset_voxels * 2 * longest / settings.subdiv  # the shader takes it as metres
	add_child(probe)
	var start = OS.get_ticks_usec()
	probe.bake(self, false)
	return (OS.get_ticks_usec() - start) / 1000.0


func next_frames(count):
	for i in range(count):
		yield(get_tree(), "idle_frame")


func _ready():
	var file = File.new()
	file.open(OS.get_environment("VCT_JOB"), File.READ)
	var job = JSON.parse(file.get_as_text()).result
	file.close()
	var size = (vector(job.scene.bounds[1]) - vector(job.scene.bounds[0])).length()
	OS.window_size = Vector2(job.scene.size[0], job.scene.size[1])

	environment.background_mode = Environment.BG_COLOR
	environment.background_color = Color(0, 0, 0)
	environment.ambient_light_energy = 0
	environment.tonemap_mode = Environment.TONE_MAPPER_LINEAR
	camera.environment = environment
	var axes = job.scene.camera.right_up_back
	camera.transform = Transform(Basis(vector(axes[0]), vector(axes[1]), vector(axes[2])), vector(job.scene.camera.eye))
	camera.fov = job.scene.camera.vertical_fov_deg  # vertical, as keep_aspect is KEEP_HEIGHT
	camera.near = 0.01 * size
	camera.far = 10 * size
	add_child(camera)
	for surface in job.scene.surfaces:
		add_child(mesh_of(surface))
	var farthest = 0.0
	for corner in range(8):
		var at = Vector3(job.scene.bounds[corner & 1][0], job.scene.bounds[corner >> 1 & 1][1], job.scene.bounds[corner >> 2][2])
		farthest = max(farthest, camera.translation.distance_to(at))
	add_sun(job.scene.sun, farthest)
	var report = {"driver": VisualServer.get_video_adapter_name(), "version": Engine.get_version_info().string}
	if job.settings.size() > 0:
		report.bake_ms = add_probe(job.scene.bounds, job.settings)
	yield(next_frames(WARM_UP_FRAMES), "completed")
	yield(get_tree().create_timer(2), "timeout")

	var times = []
	for i in range(TIMED_FRAMES):
		var start = OS.get_ticks_usec()
		camera.translate(Vector3(0.0001 * size, 0, 0))
		yield(get_tree(), "idle_frame")
		times.append((OS.get_ticks_usec() - start) / 1000.0)
	times.sort()
	report.frame_ms = times[TIMED_FRAMES / 2]
	camera.translate(Vector3(-0.0001 * size * TIMED_FRAMES, 0, 0))

	OS.window_size = job.samples * OS.window_size
	for i in range(job.exposures.size()):
		environment.tonemap_exposure = job.exposures[i]
		yield(next_frames(2), "completed")
		var image = get_viewport().get_texture().get_data()
		image.flip_y()
		image.save_png("%s/%d.png" % [job.out, i])

	file.open(job.out + "/report.json", File.WRITE)
	file.store_string(JSON.print(report))
	file.close()
	get_tree().quit()
